"""From a scene to straight-line code: a compiler for the equations of flexible multibody systems.

Its stages are its folders, in this order: `scene` (what is there), `system` (equations in all coordinates, with the
topology), `choice` (dependent coordinates and groups), `condensed` (the dependent ones substituted), `kernels` (named
functions), `tapes` (straight-line code), `emission` (files). Bodies, joints and loads state what a system is made of,
in the `algebra` of templates; `modes` and `fe` compute numbers for scenes; `urdf` reads robots; `scenes` are built in;
`cli` is the command line, `schema` what the text of scenes is made of. `pipeline.py` says the same with equation
numbers, `notation` names the symbols.
"""
