// @foxglove/ws-protocol, the client that Foxglove itself uses: subscribes to all, says what it hears.
// node foxglove_peer.mjs FOLDER_WITH_NODE_MODULES URL PROTOCOL
import { createRequire } from "node:module";

const [folder, url, protocol] = process.argv.slice(2);
const require = createRequire(`${folder}/node_modules/`);
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const { WebSocket } = require("ws");

const client = new FoxgloveClient({ ws: new WebSocket(url, [protocol]) });
const channels = new Map();
client.on("error", (error) => console.log("ERROR", error.message));
client.on("serverInfo", ({ name }) => console.log("SERVER", name.split(" ")[0]));
client.on("status", ({ message }) => console.log("STATUS", message));
client.on("advertise", (advertised) => {
  for (const channel of advertised) {
    channels.set(client.subscribe(channel.id), channel);
    console.log("CHANNEL", channel.schemaName, JSON.parse(channel.schema).title, channel.encoding);
  }
});
client.on("message", ({ subscriptionId, timestamp, data }) => {
  const channel = channels.get(subscriptionId);
  const message = JSON.parse(new TextDecoder().decode(data));
  const recent = Math.abs(Number(timestamp / 1000000n) - Date.now()) < 3600000;
  if (channel.topic === "/handmap/pose") console.log("POSE", message.pose.position.x, recent);
  else if (channel.topic === "/handmap/map") console.log("MAP", message.entities.length, message.entities[0].lines[0].points.length);
});
