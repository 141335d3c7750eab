// Search from the disk. A browser starts no worker from file: addresses; there the script of the
// worker runs in a hidden frame instead, and messages go to and fro as to a worker.
if (location.protocol === "file:") {
  window.Worker = class extends EventTarget {
    constructor(address) {
      super();
      const frame = document.createElement("iframe");
      frame.hidden = true;
      document.body.appendChild(frame);
      const inside = frame.contentWindow;
      this.waiting = [];
      inside.postMessage = (data) => this.dispatchEvent(new MessageEvent("message", {data}));
      this.deliver = (data) => inside.dispatchEvent(new inside.MessageEvent("message", {data}));
      const script = inside.document.createElement("script");
      script.src = new URL(address, location.href).href;
      script.onload = () => {
        this.waiting.forEach(this.deliver);
        this.waiting = null;
      };
      inside.document.head.appendChild(script);
    }
    postMessage(data) {
      if (this.waiting) this.waiting.push(data);
      else this.deliver(data);
    }
  };
}
