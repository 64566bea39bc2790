// roslib, the official client of rosbridge: sends odometry, says what it hears.
// node roslib_peer.mjs FOLDER_WITH_NODE_MODULES URL
import { pathToFileURL } from "node:url";

const [folder, url] = process.argv.slice(2);
const entry = `${folder}/node_modules/roslib/dist/RosLib.js`;
const { Ros, Topic } = await import(pathToFileURL(entry).href);

const ros = new Ros({ url });
const topic = (name, messageType, more = {}) => new Topic({ ros, name, messageType, ...more });
const hear = (name, type, say, more) =>
  topic(name, type, more).subscribe((message) => console.log(say(message)));

ros.on("error", (error) => console.log("ERROR", error.message ?? error));
ros.on("connection", () => {
  hear("/handmap/pose", "geometry_msgs/msg/PoseWithCovarianceStamped", ({ header, pose }) =>
    `POSE ${pose.pose.position.x} ${pose.covariance[35]} ${header.frame_id} ${header.stamp.sec > 1e9}`);
  hear("/handmap/map", "nav_msgs/msg/OccupancyGrid", ({ info, data }) =>
    `GRID ${info.width * info.height === data.length} ${data.filter((cell) => cell === 100).length} ${info.resolution}`);
  hear("/handmap/buildings", "visualization_msgs/msg/MarkerArray", ({ markers }) =>
    `MARKERS ${markers.length} ${markers[1].points.length}`);
  hear("/scan", "sensor_msgs/msg/LaserScan", ({ ranges }) =>
    `SCAN ${ranges.constructor.name} ${ranges.length} ${ranges[3]}`, { compression: "cbor" });
  const odometry = topic("/odom", "nav_msgs/msg/Odometry");
  let n = 0;
  setInterval(() => {
    n += 1;
    odometry.publish({
      header: { stamp: { sec: 100 + Math.floor(n / 100), nanosec: (n % 100) * 10000000 }, frame_id: "odom" },
      child_frame_id: "base",
      pose: {
        pose: { position: { x: 0.01 * n, y: -2, z: 0 }, orientation: { x: 0, y: 0, z: 1, w: 0 } },
        covariance: new Array(36).fill(0),
      },
    });
  }, 10);
});
