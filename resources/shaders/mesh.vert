layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in vec2 texcoord;

uniform mat4 clipFromObject;
uniform vec4 clipPlanes[8]; // in the space of the positions
uniform mat3 eyeNormalFromObject;
uniform mat3 eyeFromObject; // without the way between the origins: only differences of places count

out float gl_ClipDistance[8];
out vec3 eyeNormal;
out vec3 eyePosition;
out vec4 vertexColor;
out vec2 uv;

void main()
{
    gl_Position = clipFromObject * vec4(position, 1.0);
    for (int i = 0; i < 8; ++i)
        gl_ClipDistance[i] = dot(clipPlanes[i], vec4(position, 1.0));
    eyeNormal = eyeNormalFromObject * normal;
    eyePosition = eyeFromObject * position;
    vertexColor = color;
    uv = texcoord;
}
