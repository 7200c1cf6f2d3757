// Something for orientation, about a solid.
%cube(16, center = true);
sphere(6, $fn = 48);
