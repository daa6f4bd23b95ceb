// Meshes that the page holds: packed until they are shown.

const kMeshesKept = 12;
const meshesLoaded = new Map();  // by id, the latest last

/** The mesh of a script element, a promise; the last few stay unpacked. */
function loadMesh(id) {
  const mesh = meshesLoaded.get(id) || unpackMesh(document.getElementById(id).textContent);
  meshesLoaded.delete(id);
  meshesLoaded.set(id, mesh);
  if (meshesLoaded.size > kMeshesKept) meshesLoaded.delete(meshesLoaded.keys().next().value);
  return mesh;
}

/** Base64 of gzip of a mesh blob. */
async function unpackMesh(text) {
  const packed = Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return decodeMesh(new Uint8Array(await new Response(stream).arrayBuffer()));
}
