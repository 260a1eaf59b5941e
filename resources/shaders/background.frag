uniform vec4 bottom;
uniform vec4 top;
in float height;
out vec4 fragment;

void main()
{
    fragment = mix(bottom, top, height);
}
