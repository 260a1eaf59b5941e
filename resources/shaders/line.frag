in vec4 lineColor;
in float acrossPixels;

uniform float halfWidth;

out vec4 fragment;

void main()
{
    float cover = clamp(halfWidth + 0.5 - abs(acrossPixels), 0.0, 1.0);
    fragment = vec4(lineColor.rgb, lineColor.a * cover);
}
