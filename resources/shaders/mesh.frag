in vec3 eyeNormal;
in vec3 eyePosition;
in vec4 vertexColor;
in vec2 uv;

uniform vec4 baseColor;
uniform bool isTextured;
uniform bool isFlat;  // a triangle has one normal, its own
uniform bool isPoint; // and a point none
uniform sampler2D baseTexture;

layout(location = 0) out vec4 fragment;

// Which object this is, 1 for the first. Where a driver has no framebuffers of integers, its four bytes are a colour.
uniform uint object;
#ifdef OBJECT_IDS_ARE_COLORS
layout(location = 1) out vec4 objectId;
vec4 written(uint id) { return vec4((uvec4(id) >> uvec4(0u, 8u, 16u, 24u)) & 255u) / 255.0; }
#else
layout(location = 1) out uint objectId;
uint written(uint id) { return id; }
#endif

// A key light over the camera's left shoulder and a dim fill from the right: both move with the camera, so no side of
// a model is ever dark. Surfaces are lit on both sides, because scans are often wound the wrong way.
void main()
{
    vec4 color = baseColor * vertexColor;
    if (isTextured)
        color *= texture(baseTexture, uv);
    vec3 n;
    if (isPoint) {
        n = vec3(0.0, 0.0, 1.0);
    } else if (isFlat) {
        // Along the screen's axes: it always looks to the viewer.
        n = normalize(cross(dFdx(eyePosition), dFdy(eyePosition)));
    } else {
        n = normalize(eyeNormal);
        if (!gl_FrontFacing)
            n = -n;
    }
    const vec3 key = vec3(-0.36, 0.48, 0.80);
    const vec3 fill = vec3(0.60, -0.10, 0.79);
    float light = 0.38 + 0.58 * max(dot(n, key), 0.0) + 0.18 * max(dot(n, fill), 0.0);
    float gloss = 0.12 * pow(max(dot(n, normalize(key + vec3(0.0, 0.0, 1.0))), 0.0), 40.0);
    fragment = vec4(color.rgb * light + gloss, 1.0);
    objectId = written(object);
}
