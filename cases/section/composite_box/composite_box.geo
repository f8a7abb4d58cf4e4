// Box, inches: outside 0.953 x 0.530, walls 0.030.
// gmsh -2 -format msh41 composite_box.geo -o composite_box.msh
b = 0.953; h = 0.530; t = 0.030;
// clockwise from the upper left corner, outside and inside
Point(1) = {-b/2, h/2, 0};         Point(11) = {-b/2 + t, h/2 - t, 0};
Point(2) = {b/2, h/2, 0};          Point(12) = {b/2 - t, h/2 - t, 0};
Point(3) = {b/2, -h/2, 0};         Point(13) = {b/2 - t, -h/2 + t, 0};
Point(4) = {-b/2, -h/2, 0};        Point(14) = {-b/2 + t, -h/2 + t, 0};
For i In {1:4}
  j = (i % 4) + 1;
  Line(i) = {i, j};
  Line(10 + i) = {10 + i, 10 + j};
  Line(20 + i) = {i, 10 + i};
  Transfinite Curve{20 + i} = 3 + 1;
EndFor
Transfinite Curve{1, 3, 11, 13} = 24 + 1;
Transfinite Curve{2, 4, 12, 14} = 14 + 1;
For i In {1:4}
  j = (i % 4) + 1;
  Curve Loop(i) = {20 + i, 10 + i, -(20 + j), -i};
  Plane Surface(i) = {i};
EndFor
Transfinite Surface{1:4};
Recombine Surface{1:4};
Physical Surface("wall", 1) = {1:4};
// clockwise, so that the normals of the wall point outward
Physical Curve("outer", 2) = {1:4};
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1; // 8 nodes
