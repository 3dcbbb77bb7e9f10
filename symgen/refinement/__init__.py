"""A scene with one thing of its modelling changed: more shapes, more or fewer pieces, a coarser mesh, stiffening."""
