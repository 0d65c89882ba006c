// camera-controls with the parts of three.js that it needs.

import CameraControls from 'camera-controls';
import {Box3, Matrix4, Quaternion, Raycaster, Sphere, Spherical, Vector2, Vector3, Vector4} from 'three';

CameraControls.install({
  THREE: {Box3, Matrix4, Quaternion, Raycaster, Sphere, Spherical, Vector2, Vector3, Vector4}
});

export const actions = CameraControls.ACTION;

export function newControls(camera, canvas) {
  const controls = new CameraControls(camera, canvas);
  controls.smoothTime = 0.22;
  controls.draggingSmoothTime = 0.06;
  controls.restThreshold = 0.002;
  controls.enabled = false;
  return controls;
}
