// What a mesh has is told by definitions, not by uniforms: renderers on the processor compute both sides of an `if`.
// COLORED, TEXTURED; FLAT where a triangle has one normal, its own; POINTS, which have none. The shading adds
// SIDE_LIT, CURVED and EDGES, with INDEXED where triangles share vertices.
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
#ifdef SIDE_LIT
uniform vec3 sideLight; // the direction to it, eye space
#endif
#ifdef CURVED
in float vertexCurvature;
uniform float ridgeSign; // of front sides
#endif

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

#ifdef CURVED
// Ridges go to a warm white, valleys to a dark blue, flat parts to a medium tone of the color.
vec3 curved(vec3 color)
{
    float bend = gl_FrontFacing ? ridgeSign * vertexCurvature : -ridgeSign * vertexCurvature;
    vec3 tone = 0.72 * color;
    return bend > 0.0 ? mix(tone, vec3(1.0, 0.97, 0.89), 0.9 * bend) : mix(tone, vec3(0.04, 0.06, 0.18), -0.9 * bend);
}
#endif

#ifdef EDGES
uniform mat4 clipFromObject;
uniform samplerBuffer coordinates;     // x, y, z of each vertex
uniform usamplerBuffer vertexNumbers;  // of each corner
uniform int firstTriangle;
uniform vec2 viewportMiddle, viewportHalf; // pixels
uniform float edgeScale;                   // pixels for a logical one

// A corner of this triangle: its way from this pixel times w, and w.
vec3 cornerFromPixel(int k)
{
    int vertex = 3 * (firstTriangle + gl_PrimitiveID) + k;
#ifdef INDEXED
    vertex = int(texelFetch(vertexNumbers, vertex).r);
#endif
    vec4 clip = clipFromObject
                * vec4(texelFetch(coordinates, 3 * vertex).r, texelFetch(coordinates, 3 * vertex + 1).r,
                       texelFetch(coordinates, 3 * vertex + 2).r, 1.0);
    vec3 corner = vec3(clip.xy * viewportHalf - (gl_FragCoord.xy - viewportMiddle) * clip.w, clip.w);
    return corner / max(max(abs(corner.x), abs(corner.y)), max(abs(corner.z), 1e-30));
}

// How much of this pixel the edges of its triangle cover. Edges of triangles of a few pixels fade away: they would
// hide the surface.
float edgeInk()
{
    vec3 a = cornerFromPixel(0), b = cornerFromPixel(1), c = cornerFromPixel(2);
    // The lines through two corners. They are right for corners behind the eye, too.
    vec3 ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
    vec3 lengths = max(vec3(length(ab.xy), length(bc.xy), length(ca.xy)), vec3(1e-30));
    vec3 ways = abs(vec3(ab.z, bc.z, ca.z)) / lengths;
    vec3 heights = abs(vec3(dot(ab, c), dot(bc, a), dot(ca, b))) / (lengths * max(abs(vec3(c.z, a.z, b.z)), 1e-30));
    float height = min(heights.x, min(heights.y, heights.z)) / edgeScale;
    // Each side of an edge draws half of it.
    float ink = 1.0 - smoothstep(0.5 * edgeScale - 0.25, 0.5 * edgeScale + 0.75, min(ways.x, min(ways.y, ways.z)));
    return 0.6 * ink * smoothstep(2.5, 8.0, height);
}
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
#ifdef CURVED
    color.rgb = curved(color.rgb);
#endif
#ifdef SIDE_LIT
    vec3 shaded = color.rgb * (0.10 + 0.20 * n.z + 0.85 * max(dot(n, sideLight), 0.0));
#else
    const vec3 key = vec3(-0.36, 0.48, 0.80);
    const vec3 fill = vec3(0.60, -0.10, 0.79);
    float light = 0.38 + 0.58 * max(dot(n, key), 0.0) + 0.18 * max(dot(n, fill), 0.0);
    // Its fortieth power, without the logarithm that pow() takes.
    float shine = max(dot(n, normalize(key + vec3(0.0, 0.0, 1.0))), 0.0);
    float shine2 = shine * shine, shine4 = shine2 * shine2, shine8 = shine4 * shine4, shine16 = shine8 * shine8;
    float gloss = 0.12 * shine16 * shine16 * shine8;
    vec3 shaded = color.rgb * light + gloss;
#endif
#ifdef EDGES
    // Dark on light surfaces, light on dark ones.
    float brightness = dot(shaded, vec3(0.3, 0.6, 0.1));
    shaded = mix(shaded, brightness > 0.25 ? 0.2 * shaded : shaded + 0.4, edgeInk());
#endif
    fragment = vec4(shaded, 1.0);
    objectId = written(object);
}
