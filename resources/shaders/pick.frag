in vec2 offset;

uniform float pixelRatio;
uniform bool isGiven;

out vec4 fragment;

// A dot and a ring, or of a given point a square on its corner, each with a light rim so that they show on any colour.
void main()
{
    vec2 side = abs(offset);
    float r = isGiven ? (side.x + side.y) / sqrt(2.0) : length(offset);
    float soft = 0.5 / pixelRatio;
    float dotShape = 1.0 - smoothstep(2.0 - soft, 2.0 + soft, r);
    float ring = 1.0 - smoothstep(1.0 - soft, 1.0 + soft, abs(r - 7.0));
    float rim = max(1.0 - smoothstep(3.2 - soft, 3.2 + soft, r),
                    1.0 - smoothstep(2.2 - soft, 2.2 + soft, abs(r - 7.0)));
    float ink = max(dotShape, ring);
    fragment = vec4(mix(vec3(1.0), isGiven ? vec3(0.80, 0.45, 0.0) : vec3(0.85, 0.10, 0.30), ink), max(ink, rim * 0.85));
}
