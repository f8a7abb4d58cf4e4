// Channel, millimeters: flanges 100 and web 200 along the midline, walls 2.
// gmsh -2 -format msh41 channel.geo -o channel.msh
b = 100; h = 200; t = 2;
along = 30;   // cells along a flange
up = 60;      // cells along the web
through = 2;  // cells through a wall

// columns at y = -t/2, t/2, b; rows at z = -h/2 -+ t/2, h/2 -+ t/2
ys[] = {-t/2, t/2, b};
zs[] = {-h/2 - t/2, -h/2 + t/2, h/2 - t/2, h/2 + t/2};
For j In {0:3}
  For i In {0:2}
    Point(10*j + i + 1) = {ys[i], zs[j], 0};
  EndFor
EndFor

// lines along y in each row, along z in each column
For j In {0:3}
  Line(100 + j) = {10*j + 1, 10*j + 2};
  Transfinite Curve{100 + j} = through + 1;
  Line(110 + j) = {10*j + 2, 10*j + 3};
  Transfinite Curve{110 + j} = along + 1;
EndFor
For i In {0:1}
  Line(200 + i) = {i + 1, i + 11};
  Line(210 + i) = {i + 11, i + 21};
  Line(220 + i) = {i + 21, i + 31};
  Transfinite Curve{200 + i, 220 + i} = through + 1;
  Transfinite Curve{210 + i} = up + 1;
EndFor
Line(202) = {3, 13}; Line(222) = {23, 33};
Transfinite Curve{202, 222} = through + 1;

Curve Loop(1) = {100, 201, -101, -200}; Plane Surface(1) = {1};
Curve Loop(2) = {110, 202, -111, -201}; Plane Surface(2) = {2};
Curve Loop(3) = {101, 211, -102, -210}; Plane Surface(3) = {3};
Curve Loop(4) = {102, 221, -103, -220}; Plane Surface(4) = {4};
Curve Loop(5) = {112, 222, -113, -221}; Plane Surface(5) = {5};
Transfinite Surface{1:5};
Recombine Surface{1:5};
Physical Surface("lower flange", 1) = {2};
Physical Surface("web", 2) = {1, 3, 4};
Physical Surface("upper flange", 3) = {5};
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1; // 8 nodes
