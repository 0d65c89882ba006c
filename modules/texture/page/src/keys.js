// Keys, which act wherever no text is typed.

export function listenToKeys(actions) {
  addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey)
      return;
    const is_typing = event.target instanceof HTMLInputElement && event.target.type === 'search';
    if (is_typing && event.key !== 'Escape')
      return;
    const action = actions[event.key];
    if (!action)
      return;
    event.preventDefault();
    action();
  });
}
