"""What things of known shape in the photo say of the camera: rectangles, and traced lines."""
