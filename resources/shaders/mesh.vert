layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in vec2 texcoord;

uniform mat4 clipFromObject;
uniform mat3 eyeNormalFromObject;

out vec3 eyeNormal;
out vec4 vertexColor;
out vec2 uv;

void main()
{
    gl_Position = clipFromObject * vec4(position, 1.0);
    eyeNormal = eyeNormalFromObject * normal;
    vertexColor = color;
    uv = texcoord;
}
