layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;

out vec4 faceColor;

void main()
{
    gl_Position = position;
    faceColor = color;
}
