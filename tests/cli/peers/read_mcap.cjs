// Reads an MCAP as other programs do: by its index, each message by its own schema. Prints the topics with
// how many messages they have, and the last pose.
const {loadDecompressHandlers} = require("@mcap/support");
const {FileHandleReadable} = require("@mcap/nodejs");
const {McapIndexedReader} = require("@mcap/core");
const {parse} = require("@foxglove/rosmsg");
const {MessageReader} = require("@foxglove/rosmsg2-serialization");
const fs = require("node:fs/promises");

async function main() {
  const readable = new FileHandleReadable(await fs.open(process.argv[2]));
  const reader = await McapIndexedReader.Initialize({
    readable, decompressHandlers: await loadDecompressHandlers()});
  const decoders = new Map();
  for (const [id, channel] of reader.channelsById) {
    const schema = reader.schemasById.get(channel.schemaId);
    const text = new TextDecoder().decode(schema.data);
    decoders.set(id, new MessageReader(parse(text, {ros2: true})));
  }
  const counts = {};
  let pose;
  let marker;
  for await (const message of reader.readMessages()) {
    const topic = reader.channelsById.get(message.channelId).topic;
    const decoded = decoders.get(message.channelId).readMessage(message.data);
    counts[topic] = (counts[topic] ?? 0) + 1;
    if (topic === "/pose") pose = decoded.pose.position;
    if (topic === "/buildings") marker = decoded.markers[1].text;
  }
  const attachments = [];
  for await (const attachment of reader.readAttachments()) attachments.push(attachment.name);
  console.log(JSON.stringify({counts, pose, marker, attachments}));
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
