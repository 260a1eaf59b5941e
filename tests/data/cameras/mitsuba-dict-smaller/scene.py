scene = mi.load_dict({
    'type': 'scene',
    'integrator': {'type': 'path', 'max_depth': 8},
    'camera': {
        'type': 'thinlens',
        'fov': 42.5,
        'fov_axis': 'smaller',
        'near_clip': 0.1,
        'far_clip': 200.0,
        'to_world': mi.ScalarTransform4f().look_at(
            origin=[3, -4, 2], target=[0.5, 0.25, -0.5], up=[0, 0.2, 1]),
        'film': {'type': 'hdrfilm', 'width': 1200, 'height': 700},
    },
    'lamp': {'type': 'point', 'position': [0, 3, -4], 'to_world': mi.ScalarTransform4f.translate([0, -2, 0])},
})
