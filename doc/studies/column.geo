// Half a column of material behind a gate, and the floor that it runs out on.
// The gate has the role of an outlet: a wall in the static stage, nothing in
// the particle stage. Lengths in m; the study sets them by -setnumber.
DefineConstant[width = 0.1, height = 0.1, length = 0.4, top = 0.13, size = 0.01,
               squares = 0];

Point(1) = {0, 0, 0, size};
Point(2) = {width, 0, 0, size};
Point(3) = {length, 0, 0, size};
Point(4) = {0, height, 0, size};
Point(5) = {width, height, 0, size};
Point(6) = {length, height, 0, size};
Point(7) = {0, top, 0, size};
Point(8) = {width, top, 0, size};
Point(9) = {length, top, 0, size};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 5};
Line(4) = {5, 6};
Line(5) = {7, 8};
Line(6) = {8, 9};
Line(7) = {1, 4};
Line(8) = {2, 5};
Line(9) = {3, 6};
Line(10) = {4, 7};
Line(11) = {5, 8};
Line(12) = {6, 9};

Curve Loop(1) = {1, 8, -3, -7};
Curve Loop(2) = {2, 9, -4, -8};
Curve Loop(3) = {3, 11, -5, -10};
Curve Loop(4) = {4, 12, -6, -11};
For i In {1 : 4}
  Plane Surface(i) = {i};
EndFor

If (squares)
  Transfinite Curve{1, 3, 5} = Round(width / size) + 1;
  Transfinite Curve{2, 4, 6} = Round((length - width) / size) + 1;
  Transfinite Curve{7, 8, 9} = Round(height / size) + 1;
  Transfinite Curve{10, 11, 12} = Round((top - height) / size) + 1;
  Transfinite Surface{1 : 4};
  Recombine Surface{1 : 4};
EndIf

Physical Curve("axis") = {7, 10};
Physical Curve("floor") = {1, 2};
Physical Curve("wall") = {9, 12};
Physical Curve("outlet") = {8};
Physical Curve("top") = {3, 5, 6};
Physical Surface("material") = {1};
Physical Surface("fall_region") = {2 : 4};
