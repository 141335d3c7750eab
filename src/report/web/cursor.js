// The place along the track that plots, replay and drawings share. Whoever changes it tells the
// others; whoever is told draws and tells nobody.
"use strict";
phs.cursor = (() => {
  const followers = [];
  let place = null;
  return {
    /** `follow(x)` is called whenever somebody else moves the cursor. */
    join(follow) {
      followers.push(follow);
      return {
        move(x) {
          if (x === place) return;
          place = x;
          for (const other of followers) if (other !== follow) other(x);
        },
      };
    },
    get place() { return place; },
  };
})();
