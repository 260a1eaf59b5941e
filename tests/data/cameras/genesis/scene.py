import genesis as gs

gs.init(backend=gs.cpu)
scene = gs.Scene(show_viewer=False)
ball = scene.add_entity(gs.morphs.Sphere(pos=(0.0, 0.0, 1.0), radius=0.2))
camera = scene.add_camera(
    res=(960, 540),
    pos=np.array([2.5, -1.5, 1.25]),  # to the right of the ball
    lookat=(0.25, 0.5, 0.75),
    up=(0.1, 0.0, 1.0),
    fov=38,
    near=0.05,
)
