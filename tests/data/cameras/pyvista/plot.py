plotter.set_background("#05060a")
plotter.camera_position = [(2.6, -3.1, 1.7), (0.1, 0.2, -0.3), (0.0, 0.0, 1.0)]
plotter.show()
