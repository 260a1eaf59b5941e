// What a mesh has is told by definitions, not by uniforms: renderers on the processor compute both sides of an `if`.
// COLORED, TEXTURED; FLAT where a triangle has one normal, its own; POINTS, which have none.
#if defined(FLAT)
in vec3 eyePosition;
#elif !defined(POINTS)
in vec3 eyeNormal;
#endif
#ifdef COLORED
in vec4 vertexColor;
#endif
#ifdef TEXTURED
in vec2 uv;
uniform sampler2D baseTexture;
#endif

uniform vec4 baseColor;

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
    vec4 color = baseColor;
#ifdef COLORED
    color *= vertexColor;
#endif
#ifdef TEXTURED
    color *= texture(baseTexture, uv);
#endif
#if defined(POINTS)
    vec3 n = vec3(0.0, 0.0, 1.0);
#elif defined(FLAT)
    // Along the screen's axes: it always looks to the viewer.
    vec3 n = normalize(cross(dFdx(eyePosition), dFdy(eyePosition)));
#else
    vec3 n = normalize(eyeNormal);
    if (!gl_FrontFacing)
        n = -n;
#endif
    const vec3 key = vec3(-0.36, 0.48, 0.80);
    const vec3 fill = vec3(0.60, -0.10, 0.79);
    float light = 0.38 + 0.58 * max(dot(n, key), 0.0) + 0.18 * max(dot(n, fill), 0.0);
    // Its fortieth power, without the logarithm that pow() takes.
    float shine = max(dot(n, normalize(key + vec3(0.0, 0.0, 1.0))), 0.0);
    float shine2 = shine * shine, shine4 = shine2 * shine2, shine8 = shine4 * shine4, shine16 = shine8 * shine8;
    float gloss = 0.12 * shine16 * shine16 * shine8;
    fragment = vec4(color.rgb * light + gloss, 1.0);
    objectId = written(object);
}
