camera {
  location <2, -3.5, 5>
  sky <0, 0, 1>
  right -x*4/3
  up y
  look_at <0.25, 0.5, 1.0>
}
