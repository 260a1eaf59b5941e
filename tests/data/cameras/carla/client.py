library = world.get_blueprint_library()
lidar = library.find('sensor.lidar.ray_cast')
lidar.set_attribute('range', '50')
camera = library.find('sensor.camera.rgb')
camera.set_attribute('image_size_x', '1024')  # pixels
camera.set_attribute('image_size_y', '576')
camera.set_attribute("fov", "75.5")
transform = carla.Transform(
    carla.Location(x=-3.5, y=1.25, z=2.0),  # behind the car
    carla.Rotation(pitch=-12.0, yaw=35.0, roll=8.0))
sensor = world.spawn_actor(camera, transform, attach_to=car)
