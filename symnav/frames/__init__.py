"""Frames: rotations, small-angle series, geodesy and earth constants."""
