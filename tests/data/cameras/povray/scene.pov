#version 3.7;
#include "colors.inc"
/* camera { location <0, 0, 0> } */
camera {
  perspective
  location <2, 3.5, -5> // before the box
  look_at <0.25, 0.5, 1.0>
  right x*image_width/image_height
  up y
  sky <0.1, 1, 0>
  angle 47.5
}
light_source { <20, 20, -20> color rgb <1, 1, 1> }
box { <-1, -1, -1>, <1, 1, 1> rotate <0, 30, 0> }
