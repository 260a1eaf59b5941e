uniform vec2 center;
uniform vec2 viewportPixels;
uniform float pixelRatio;

out vec2 offset;

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
    offset = corner * 11.0;
    gl_Position = vec4(center + offset * pixelRatio * 2.0 / viewportPixels, 0.0, 1.0);
}
