"""Independent references for the built-in models, at any precision.

Nothing here knows how symnav derives anything: the modules use mpmath and the standard library
only, and wherever another way to the same number exists (sandwich products, series, iteration,
differencing) it is taken.

One module per built-in model, each with::

    def value(q: Quantities, options: Options) -> Outputs

``q`` maps the name of every *bound* quantity to a dictionary, an absent key being a quantity bound
to nothing:

vector
    ``{"value": [...], "frame": "n" or None}``; scalars and covariances (row-major) as well.
rotation
    ``{"wxyz": [w, x, y, z], "maps": ("b", "n")}``: v_n = R(q) v_b, Hamilton; or the other way
    round, ``("n", "b")``, or as a direction cosine matrix ``{"matrix": [9], "maps": ...}``.
heading
    ``{"angle": psi, "axis": "x" | "y" | "z", "maps": ("L", "G")}``: v_G = R_axis(psi) v_L.
geodetic
    ``{"llh": [latitude, longitude, height], "frame": "ecef"}`` on WGS-84.

Numbers are ``mpmath.mpf``; the caller sets ``mp.dps`` (50 or more). A mapped model receives one
item's columns. The result maps output names to flat, row-major lists. The option ``quaternion``
says how a quaternion that is not exactly of unit length acts (see
:func:`tests.reference.algebra.sandwich`).

The modules import one another relatively, so that the folder can be loaded as a package under any
name.
"""
