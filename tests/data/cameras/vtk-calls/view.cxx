actor->SetPosition(9, 9, 9);
renderer->ResetCamera();
renWin->SetSize(300, 300);
if (me > 0)
{
  renWin->SetPosition(me * 350, 0);
}
vtkCamera* camera = renderer->GetActiveCamera();
camera->SetPosition(199.431, 196.879, 15.7781);
camera->SetFocalPoint(33.5, 33.5, 33.5);
camera->SetViewUp(0.703325, -0.702557, 0.108384);
camera->SetViewAngle(30);
camera->SetClippingRange(132.14, 361.741);
