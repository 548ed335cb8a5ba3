// Half a closed silo with a flat bottom and an insert on the axis, between the
// heights `upper` and `lower` there and from `outer_upper` to `outer_lower` at
// its outer side (a corner if both are the same). Lengths in m; the study sets
// them by -setnumber.
DefineConstant[half_width = 1, height = 3, insert_width = 0.4, upper = 1.4,
               outer_upper = 1, outer_lower = 1, lower = 0.9, size = 0.1,
               squares = 0];

Point(1) = {0, 0, 0, size};
Point(2) = {half_width, 0, 0, size};
Point(3) = {half_width, height, 0, size};
Point(4) = {0, height, 0, size};
Point(5) = {0, upper, 0, size};
Point(6) = {insert_width, outer_upper, 0, size};
Point(7) = {insert_width, outer_lower, 0, size};
Point(8) = {0, lower, 0, size};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(8) = {8, 1};
If (outer_upper > outer_lower)
  Line(6) = {6, 7};
  Line(7) = {7, 8};
  Curve Loop(1) = {1 : 8};
  Physical Curve("hopper") = {5, 6, 7};
Else
  Line(7) = {6, 8};
  Curve Loop(1) = {1, 2, 3, 4, 5, 7, 8};
  Physical Curve("hopper") = {5, 7};
EndIf
Plane Surface(1) = {1};

If (squares)
  Recombine Surface{1};
  Mesh.RecombinationAlgorithm = 1;
  Mesh.SubdivisionAlgorithm = 1;
EndIf

Physical Curve("outlet") = {1};
Physical Curve("wall") = {2};
Physical Curve("top") = {3};
Physical Curve("axis") = {4, 8};
Physical Surface("material") = {1};
