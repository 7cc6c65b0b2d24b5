"""The sizes of a lifted sketch, to read and to set: lengths, diameters, heights, angles."""
