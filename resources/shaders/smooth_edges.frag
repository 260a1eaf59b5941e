// The edges of a drawn frame, smooth: drawn over a copy of it, which is kept where there is no edge. Colours alone.
//
// Smooth edges are those of Timothy Lottes, "FXAA", 2009: where brightness changes, the edge's direction is found, the
// edge is followed to both its ends, and the colour is taken from so far across the edge as a straight line between
// those ends would cover of the pixel.
uniform sampler2D colors;

out vec4 fragment;

// Below these differences in brightness (of 1, and of the brightest neighbour) there is no edge to be seen.
const float kLeastContrast = 0.03;
const float kLeastShareOfBrightest = 0.10;
// How much a single bright or dark pixel is blended with its neighbours.
const float kSubpixelShare = 0.6;
// How far to follow an edge, pixels: each pixel nearby, then coarser.
const int kStepCount = 9;
const float kSteps[kStepCount] = float[](1.0, 2.0, 3.0, 4.5, 6.5, 8.5, 11.0, 15.0, 23.0);

float brightness(vec3 color)
{
    return dot(color, vec3(0.299, 0.587, 0.114));
}

float brightnessAt(ivec2 pixel)
{
    return brightness(texelFetch(colors, clamp(pixel, ivec2(0), textureSize(colors, 0) - 1), 0).rgb);
}

/// How far from the pixel's centre to take its colour, in pixels.
/// @param middle, up, down, left, right  brightness of the pixel and of those beside it
vec2 shiftOnEdge(ivec2 pixel, float middle, float up, float down, float left, float right, float contrast)
{
    ivec2 size = textureSize(colors, 0);
    float upLeft = brightnessAt(pixel + ivec2(-1, 1)), upRight = brightnessAt(pixel + ivec2(1, 1));
    float downLeft = brightnessAt(pixel + ivec2(-1, -1)), downRight = brightnessAt(pixel + ivec2(1, -1));
    // The edge lies across the direction that brightness bends in most.
    float bendUp = 2.0 * abs(up + down - 2.0 * middle) + abs(upRight + downRight - 2.0 * right)
                   + abs(upLeft + downLeft - 2.0 * left);
    float bendRight = 2.0 * abs(right + left - 2.0 * middle) + abs(upRight + upLeft - 2.0 * up)
                      + abs(downRight + downLeft - 2.0 * down);
    bool isLevel = bendUp >= bendRight;
    float before = isLevel ? down : left, after = isLevel ? up : right;
    bool isBefore = abs(before - middle) > abs(after - middle);
    vec2 across = (isLevel ? vec2(0.0, 1.0) : vec2(1.0, 0.0)) * (isBefore ? -1.0 : 1.0);
    vec2 along = isLevel ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    float beside = isBefore ? before : after;
    float onEdge = (middle + beside) / 2.0;
    float ending = abs(beside - middle) / 4.0;

    // Between the two rows of pixels, where linear filtering gives their mean: it stays the same as far as the edge goes.
    vec2 start = vec2(pixel) + 0.5 + across * 0.5;
    float reach[2] = float[](kSteps[kStepCount - 1], kSteps[kStepCount - 1]);
    float change[2] = float[](0.0, 0.0);
    for (int side = 0; side < 2; ++side) {
        vec2 direction = side == 0 ? -along : along;
        for (int i = 0; i < kStepCount; ++i) {
            change[side] = brightness(textureLod(colors, (start + direction * kSteps[i]) / vec2(size), 0.0).rgb) - onEdge;
            if (abs(change[side]) >= ending) {
                reach[side] = kSteps[i];
                break;
            }
        }
    }
    int nearer = reach[0] < reach[1] ? 0 : 1;
    float shift = 0.5 - reach[nearer] / (reach[0] + reach[1]);
    // The pixel is on the side that the edge leaves, or on the one that it takes: only the latter is covered.
    if ((change[nearer] < 0.0) == (middle < onEdge))
        shift = 0.0;

    float around = (2.0 * (up + down + left + right) + upLeft + upRight + downLeft + downRight) / 12.0;
    float alone = smoothstep(0.0, 1.0, clamp(abs(around - middle) / contrast, 0.0, 1.0));
    shift = max(shift, alone * alone * kSubpixelShare);
    return across * shift;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float middle = brightnessAt(pixel);
    float up = brightnessAt(pixel + ivec2(0, 1)), down = brightnessAt(pixel + ivec2(0, -1));
    float right = brightnessAt(pixel + ivec2(1, 0)), left = brightnessAt(pixel + ivec2(-1, 0));
    float highest = max(max(max(up, down), max(left, right)), middle);
    float lowest = min(min(min(up, down), min(left, right)), middle);
    float contrast = highest - lowest;
    // Few pixels are on an edge, and renderers on the processor compute both sides of an `if` for every pixel: but where all
    // pixels are discarded they go no further.
    if (contrast < max(kLeastContrast, highest * kLeastShareOfBrightest))
        discard;
    vec2 shift = shiftOnEdge(pixel, middle, up, down, left, right, contrast);
    fragment = textureLod(colors, (vec2(pixel) + 0.5 + shift) / vec2(textureSize(colors, 0)), 0.0);
}
