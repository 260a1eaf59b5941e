in vec4 faceColor;

out vec4 fragment;

void main()
{
    fragment = faceColor;
}
