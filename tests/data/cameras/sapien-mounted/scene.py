camera = scene.add_mounted_camera(
    name="hand", mount=link, pose=sapien.Pose([0.3, -0.2, 0.9], [0.9393727128473788, 0, 0.34289780745545134, 0]),
    width=640, height=480, fovy=0.9, near=0.1, far=100)
