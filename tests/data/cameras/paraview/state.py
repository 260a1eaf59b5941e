from paraview.simple import *
renderView1 = CreateView('RenderView')
renderView1.ViewSize = [400, 400]
renderView1.CameraPosition = [1, 2, 3]
renderView1.CameraFocalPoint = [0, 0, 0]
renderView1.CameraViewUp = [0, 1, 0]
renderView1.CameraViewAngle = 30
renderView1.CameraFocalDisk = 1.0
renderView1.CameraParallelScale = 443.4
renderView2 = CreateView('RenderView')
renderView2.ViewSize = [800, 600]
renderView2.CameraPosition = [256, -1457.25, 300.5]
renderView2.CameraFocalPoint = [250, 256, 240]
renderView2.CameraViewUp = [0.10000000000000001, 0, 1]
renderView2.CameraViewAngle = 21.85
renderView2.CameraFocalDisk = 1.0
renderView2.CameraParallelScale = 443.4
