// Fields as Gmsh itself writes them: x + 2 y on the nodes, and the same per element and node.
Merge "two-squares.41.ascii.msh";
Plugin(NewView).NumComp=1; Plugin(NewView).Value=1; Plugin(NewView).Run;
View[0].Name="x plus 2 y";
Plugin(ModifyComponents).View=0; Plugin(ModifyComponents).Expression0="x+2*y"; Plugin(ModifyComponents).Run;
Plugin(MathEval).View=0; Plugin(MathEval).Expression0="x+2*y"; Plugin(MathEval).Run;
PostProcessing.SaveMesh=1;
Save View[0] "node-data.41.ascii.msh";
Save View[1] "element-node-data.22.ascii.msh";
Mesh.Binary=1;
Save View[0] "node-data.41.binary.msh";
