// Rectangle 40 x 20, millimeters: steel for y < 10, aluminum beyond.
// gmsh -2 -format msh41 two_materials.geo -o two_materials.msh
ys[] = {-20, 10, 20};
cells[] = {12, 4};
For i In {0:2}
  Point(1 + i) = {ys[i], -10, 0};
  Point(11 + i) = {ys[i], 10, 0};
  Line(20 + i) = {1 + i, 11 + i};
  Transfinite Curve{20 + i} = 8 + 1;
EndFor
For i In {0:1}
  Line(1 + i) = {1 + i, 2 + i};
  Line(11 + i) = {11 + i, 12 + i};
  Transfinite Curve{1 + i, 11 + i} = cells[i] + 1;
  Curve Loop(1 + i) = {1 + i, 21 + i, -(11 + i), -(20 + i)};
  Plane Surface(1 + i) = {1 + i};
EndFor
Transfinite Surface{1, 2};
Recombine Surface{1, 2};
Physical Surface("steel", 1) = {1};
Physical Surface("aluminum", 2) = {2};
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1; // 8 nodes
