#!/usr/bin/env python3
"""Writes a Handmap recording from lists of your own: python3 write_recording.py FOLDER"""
import json, math, os, struct, sys

def write_recording(folder, scans, poses, range_limit_m):
    """scans: (time_s, [(x, y, z), …]), poses: (time_s, x, y, heading); metres, seconds, radians."""
    os.makedirs(os.path.join(folder, "points"))
    with open(os.path.join(folder, "recording.json"), "w") as file:
        json.dump({"format": "handmap-recording", "version": 1, "range_limit_m": range_limit_m}, file)
    with open(os.path.join(folder, "odometry.tum"), "w") as file:
        for time_s, x, y, heading in poses:
            file.write(f"{time_s} {x} {y} 0 0 0 {math.sin(heading / 2)} {math.cos(heading / 2)}\n")
    with open(os.path.join(folder, "frames.csv"), "w") as table:
        table.write("frame,time_s,points\n")
        for frame, (time_s, points) in enumerate(scans):
            name = f"points/{frame:06}.bin"
            table.write(f"{frame},{time_s},{name}\n")
            with open(os.path.join(folder, name), "wb") as file:
                for x, y, z in points:  # the last number: 1 where nothing is known of what it is on
                    file.write(struct.pack("<4f", x, y, z, 1.0))

if __name__ == "__main__":  # a robot that drives along a wall 5 m to its left
    ways = [0.5 * i for i in range(40)]
    scans = [(0.5 * i, [(0.25 * k - x, 5.0, 0.0) for k in range(0, 100) if abs(0.25 * k - x) < 20])
             for i, x in enumerate(ways)]
    write_recording(sys.argv[1], scans, [(0.5 * i, x, 0.0, 0.0) for i, x in enumerate(ways)], 30)
