SetFactory("Built-in");
Point(1)={0,0,0};Point(2)={1,0,0};Point(3)={0,1,0};
Circle(1)={2,1,3};Line(2)={1,2};Line(3)={3,1};
Curve Loop(1)={1,2,3};Plane Surface(1)={1};
Physical Curve("arc",1)={1};Physical Surface("quarter",7)={1};
Mesh.CharacteristicLengthMin=0.4;Mesh.CharacteristicLengthMax=0.5;
