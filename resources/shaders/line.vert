// A line as two triangles: each corner is moved across the line by half its width and one pixel of soft edge.
layout(location = 0) in vec4 from;
layout(location = 1) in vec4 to;
layout(location = 2) in vec4 color;
layout(location = 3) in vec2 corner;

uniform vec2 viewportPixels;
uniform float halfWidth;

out vec4 lineColor;
out float acrossPixels;

void main()
{
    vec2 a = from.xy / from.w * viewportPixels / 2.0;
    vec2 b = to.xy / to.w * viewportPixels / 2.0;
    vec2 along = b - a;
    float len = length(along);
    along = len > 1e-6 ? along / len : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    float reach = halfWidth + 1.0;
    vec4 clip = corner.x < 0.5 ? from : to;
    clip.xy += across * corner.y * reach * 2.0 / viewportPixels * clip.w;
    gl_Position = clip;
    acrossPixels = corner.y * reach;
    lineColor = color;
}
