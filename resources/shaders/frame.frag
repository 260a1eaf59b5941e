// A drawn frame, pixel by pixel: its colour and its depth as they are.
uniform sampler2D colors;
uniform sampler2D depths;

out vec4 fragment;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    fragment = texelFetch(colors, pixel, 0);
    gl_FragDepth = texelFetch(depths, pixel, 0).r;
}
