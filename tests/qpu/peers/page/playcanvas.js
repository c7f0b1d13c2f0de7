// SPDX-License-Identifier: MIT
import * as pc from '/npm/playcanvas/build/playcanvas.mjs';

export const version = pc.version;

function meshOf(device, scene) {
  const mesh = new pc.Mesh(device);
  mesh.setPositions(scene.positions);
  mesh.setNormals(scene.normals);
  mesh.setVertexStream(pc.SEMANTIC_TANGENT, scene.tangents, 4);
  mesh.setUvs(0, scene.uvs);
  mesh.setIndices(scene.indices);
  mesh.update();
  return mesh;
}

function textureOf(device, picture) {
  const { width, height } = picture;
  const texture = new pc.Texture(device, { width, height, format: pc.PIXELFORMAT_RGBA8, flipY: true });
  texture.setSource(picture);
  return texture;
}

// Flavour 'ggx': the engine's own GGX instead of its default, Blinn-Phong.
function materialOf(device, scene, flavour) {
  const material = new pc.StandardMaterial();
  material.diffuseMap = textureOf(device, scene.baseColour);
  material.normalMap = textureOf(device, scene.normalMap);
  material.useMetalness = true;
  material.metalness = scene.metallic;
  material.gloss = 1 - scene.roughness;
  material.enableGGXSpecular = flavour === 'ggx';
  material.useFog = false;
  material.useSkybox = false;
  material.update();
  return material;
}

const encoded = (c) => Math.pow(c, 1 / 2.2);  // the engine takes colours encoded

function addLights(app, scene) {
  app.scene.ambientLight = new pc.Color(...scene.ambient.map(encoded));
  for (const sun of scene.suns) {
    const light = new pc.Entity();
    light.addComponent('light', { type: 'directional', color: new pc.Color(...sun.colour.map(encoded)), intensity: 1 });
    const toLight = new pc.Vec3(sun.direction.map((c) => -c)).normalize();
    light.setRotation(new pc.Quat().setFromDirections(pc.Vec3.UP, toLight));  // a sun shines along its −Y
    app.root.addChild(light);
  }
}

function addCamera(app, { fieldOfView, near, far, distance }) {
  const camera = new pc.Entity();
  camera.addComponent('camera', { clearColor: new pc.Color(0, 0, 0, 1), fov: fieldOfView, nearClip: near, farClip: far });
  camera.setPosition(0, 0, distance);
  app.root.addChild(camera);
}

export async function draw(canvas, scene, flavour) {
  const app = new pc.Application(canvas, { graphicsDeviceOptions: { antialias: false } });
  app.scene.clusteredLightingEnabled = false;
  app.scene.gammaCorrection = pc.GAMMA_SRGB;
  app.scene.toneMapping = pc.TONEMAP_LINEAR;
  app.start();
  addCamera(app, scene.camera);
  addLights(app, scene);
  const sphere = new pc.Entity();
  const device = app.graphicsDevice;
  const meshInstances = [new pc.MeshInstance(meshOf(device, scene), materialOf(device, scene, flavour))];
  sphere.addComponent('render', { meshInstances });
  app.root.addChild(sphere);
  await new Promise((resolve) => app.once('frameend', () => app.once('frameend', resolve)));
}
