// SPDX-License-Identifier: MIT
import * as THREE from '/npm/three/build/three.module.js';

export const version = `r${THREE.REVISION}`;

function geometryOf(scene) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(scene.positions, 3));
  geometry.setAttribute('normal', new THREE.Float32BufferAttribute(scene.normals, 3));
  geometry.setAttribute('tangent', new THREE.Float32BufferAttribute(scene.tangents, 4));
  geometry.setAttribute('uv', new THREE.Float32BufferAttribute(scene.uvs, 2));
  geometry.setIndex(scene.indices);
  return geometry;
}

function materialOf(scene) {
  const map = new THREE.CanvasTexture(scene.baseColour);
  map.colorSpace = THREE.SRGBColorSpace;
  const normalMap = new THREE.CanvasTexture(scene.normalMap);
  return new THREE.MeshStandardMaterial({ map, normalMap, metalness: scene.metallic, roughness: scene.roughness });
}

function addLights(world, scene) {
  world.add(new THREE.AmbientLight(new THREE.Color(...scene.ambient), Math.PI));
  for (const sun of scene.suns) {
    const light = new THREE.DirectionalLight(new THREE.Color(...sun.colour), Math.PI);
    light.position.set(...sun.direction.map((c) => -c));
    world.add(light);
  }
}

export async function draw(canvas, scene) {
  const renderer = new THREE.WebGL1Renderer({ canvas, antialias: false });
  renderer.outputColorSpace = THREE.SRGBColorSpace;
  renderer.toneMapping = THREE.NoToneMapping;
  const world = new THREE.Scene();
  world.add(new THREE.Mesh(geometryOf(scene), materialOf(scene)));
  addLights(world, scene);
  const { fieldOfView, near, far, distance } = scene.camera;
  const camera = new THREE.PerspectiveCamera(fieldOfView, 1, near, far);
  camera.position.set(0, 0, distance);
  renderer.render(world, camera);
}
