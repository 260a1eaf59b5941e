layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in vec2 texcoord;
layout(location = 4) in float curvature;

uniform mat4 clipFromObject;

// The shading is in other programs: they must put each pixel at the same depth.
invariant gl_Position;

// As in mesh.frag.
#if defined(POINTS)
uniform float pointPixels; // how wide a point is drawn
#elif defined(FLAT)
uniform mat3 eyeFromObject; // without the way between the origins: only differences of places count
out vec3 eyePosition;
#else
uniform mat3 eyeNormalFromObject;
out vec3 eyeNormal;
#endif
#ifdef COLORED
out vec4 vertexColor;
#endif
#ifdef TEXTURED
out vec2 uv;
#endif
#ifdef CURVED
out float vertexCurvature;
#endif

#ifdef CLIPPED
uniform vec4 clipPlanes[8]; // in the space of the positions
out float gl_ClipDistance[8];
#endif

void main()
{
    gl_Position = clipFromObject * vec4(position, 1.0);
#ifdef CLIPPED
    for (int i = 0; i < 8; ++i)
        gl_ClipDistance[i] = dot(clipPlanes[i], vec4(position, 1.0));
#endif
#if defined(POINTS)
    gl_PointSize = pointPixels;
#elif defined(FLAT)
    eyePosition = eyeFromObject * position;
#else
    eyeNormal = eyeNormalFromObject * normal;
#endif
#ifdef COLORED
    vertexColor = color;
#endif
#ifdef TEXTURED
    uv = texcoord;
#endif
#ifdef CURVED
    vertexCurvature = curvature;
#endif
}
