// SPDX-License-Identifier: MIT
import '/npm/babylonjs/babylon.js';

const BABYLON = globalThis.BABYLON;
export const version = BABYLON.Engine.Version;

const vector = (v) => new BABYLON.Vector3(...v);
const colour = (c) => new BABYLON.Color3(...c);

function meshOf(world, scene) {
  const mesh = new BABYLON.Mesh('sphere', world);
  const data = new BABYLON.VertexData();
  Object.assign(data, { positions: scene.positions, normals: scene.normals, tangents: scene.tangents, uvs: scene.uvs, indices: scene.indices });
  data.applyToMesh(mesh);
  return mesh;
}

// Flavour 'lean': Lambert instead of energy-preserving Oren-Nayar, and no multiple scattering from a look-up texture.
function makeLean(material) {
  material.brdf.baseDiffuseModel = BABYLON.Constants.MATERIAL_DIFFUSE_MODEL_LAMBERT;
  material.brdf.useEnergyConservation = false;
  material.environmentBRDFTexture = null;
}

function materialOf(world, scene, flavour) {
  const texture = (picture) => new BABYLON.Texture(picture.toDataURL(), world);
  const material = new BABYLON.PBRMaterial('material', world);
  material.albedoTexture = texture(scene.baseColour);
  material.bumpTexture = texture(scene.normalMap);
  material.metallic = scene.metallic;
  material.roughness = scene.roughness;
  material.ambientColor = BABYLON.Color3.White();
  material.maxSimultaneousLights = scene.suns.length;
  material.sideOrientation = BABYLON.Material.CounterClockWiseSideOrientation;
  if (flavour === 'lean') makeLean(material);
  return material;
}

function addLights(world, scene) {
  world.ambientColor = colour(scene.ambient);
  scene.suns.forEach((sun, i) => {
    const light = new BABYLON.DirectionalLight(`sun${i}`, vector(sun.direction).normalize(), world);
    light.diffuse = light.specular = colour(sun.colour);
    light.intensity = Math.PI;
  });
}

export async function draw(canvas, scene, flavour) {
  const engine = new BABYLON.Engine(canvas, false);
  const world = new BABYLON.Scene(engine);
  world.useRightHandedSystem = true;
  world.clearColor = new BABYLON.Color4(0, 0, 0, 1);
  world.fogMode = BABYLON.Scene.FOGMODE_NONE;
  world.imageProcessingConfiguration.toneMappingEnabled = false;
  const { fieldOfView, near, far, distance } = scene.camera;
  const camera = new BABYLON.FreeCamera('camera', new BABYLON.Vector3(0, 0, distance), world);
  camera.setTarget(BABYLON.Vector3.Zero());
  camera.fov = fieldOfView * Math.PI / 180;
  camera.minZ = near;
  camera.maxZ = far;
  addLights(world, scene);
  meshOf(world, scene).material = materialOf(world, scene, flavour);
  await world.whenReadyAsync();
  world.render();
}
