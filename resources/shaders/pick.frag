in vec2 offset;

uniform float pixelRatio;
uniform int mark; // PickPainter::Mark

out vec4 fragment;

const int kGiven = 1, kWrong = 2, kRight = 3, kBackground = 4;
const vec3 kPicked = vec3(0.85, 0.10, 0.30);
const vec3 kColors[5] = vec3[](kPicked, vec3(0.80, 0.45, 0.0), vec3(0.76, 0.28, 0.0), vec3(0.0, 0.40, 0.70), kPicked);

// 1 up to an edge, 0 beyond it.
float within(float edge, float r)
{
    float soft = 0.5 / pixelRatio;
    return 1.0 - smoothstep(edge - soft, edge + soft, r);
}

// A dot and a ring, or the ring alone; a square on its corner; a cross; an upright square: each with a light rim so that it shows on any colour.
void main()
{
    vec2 side = abs(offset);
    float ink, rim;
    if (mark == kWrong) {
        float arm = abs(side.x - side.y) / sqrt(2.0), reach = length(offset);
        ink = within(1.4, arm) * within(8.5, reach);
        rim = within(2.8, arm) * within(10.0, reach);
    } else {
        float r = mark == kGiven ? (side.x + side.y) / sqrt(2.0) : mark == kRight ? max(side.x, side.y) : length(offset);
        float middle = mark == kBackground ? 0.0 : 1.0;
        ink = max(middle * within(2.0, r), within(1.0, abs(r - 7.0)));
        rim = max(middle * within(3.2, r), within(2.2, abs(r - 7.0)));
    }
    fragment = vec4(mix(vec3(1.0), kColors[mark], ink), max(ink, rim * 0.85));
}
