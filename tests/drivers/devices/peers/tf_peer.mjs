// roslib, as a navigation stack: composes map → odom → base_link, then says where the robot is.
// node tf_peer.mjs FOLDER_WITH_NODE_MODULES URL
import { pathToFileURL } from "node:url";

const [folder, url] = process.argv.slice(2);
const entry = `${folder}/node_modules/roslib/dist/RosLib.js`;
const { Ros, Topic } = await import(pathToFileURL(entry).href);

const ros = new Ros({ url });
const topic = (name, messageType) => new Topic({ ros, name, messageType });
const poseOf = ({ translation, rotation }) =>
  ({ x: translation.x, y: translation.y, turn: 2 * Math.atan2(rotation.z, rotation.w) });
const compose = (a, b) => ({
  x: a.x + Math.cos(a.turn) * b.x - Math.sin(a.turn) * b.y,
  y: a.y + Math.sin(a.turn) * b.x + Math.cos(a.turn) * b.y,
  turn: a.turn + b.turn,
});

const frames = new Map();
ros.on("error", (error) => console.log("ERROR", error.message ?? error));
ros.on("connection", () => {
  const given = topic("/initialpose", "geometry_msgs/msg/PoseWithCovarianceStamped");
  topic("/tf", "tf2_msgs/msg/TFMessage").subscribe(({ transforms }) => {
    for (const { header, child_frame_id, transform } of transforms)
      frames.set(`${header.frame_id}>${child_frame_id}`, poseOf(transform));
    if (!frames.has("map>odom") || !frames.has("odom>base_link")) return;
    const base = compose(frames.get("map>odom"), frames.get("odom>base_link"));
    console.log("BASE", base.x.toFixed(2), base.y.toFixed(2), base.turn.toFixed(2));
    given.publish({
      header: { stamp: { sec: 0, nanosec: 0 }, frame_id: "map" },
      pose: {
        pose: { position: { x: 21, y: 2, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } },
        covariance: new Array(36).fill(0),
      },
    });
  });
  topic("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray").subscribe(({ status }) =>
    console.log("STATE", status[0].values[0].value));
  console.log("READY");
});
