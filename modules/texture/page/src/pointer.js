// Clicks and taps, as against drags, and the place of a mouse.

const still = 6; // pixels that a click may wander

export function listenToPointer(canvas, {clicked, hovered}) {
  let down = null, pressed = 0;
  const place = event => ({x: event.clientX, y: event.clientY});
  canvas.addEventListener('pointerdown', event => {
    ++pressed;
    down = pressed === 1 && event.button === 0 ? place(event) : null;
  });
  const release = () => { pressed = Math.max(0, pressed - 1); };
  addEventListener('pointercancel', release);
  addEventListener('pointerup', event => {
    release();
    const up = place(event);
    if (down && event.target === canvas && Math.hypot(up.x - down.x, up.y - down.y) <= still)
      clicked(up, event.pointerType);
    down = null;
  });
  canvas.addEventListener('pointermove', event => {
    if (event.pointerType === 'mouse' && event.buttons === 0)
      hovered(place(event), event.pointerType);
  });
}
