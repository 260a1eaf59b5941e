in float height;
out vec4 fragment;

void main()
{
    fragment = vec4(mix(vec3(0.83, 0.85, 0.87), vec3(0.95, 0.96, 0.97), height), 1.0);
}
