// Equations of the built pages become HTML by KaTeX; its style and fonts are laid beside. A wrong one ends the
// build with its page. typeset.cjs SITE KATEX.js
const fs = require("node:fs");
const path = require("node:path");
const [site, source] = process.argv.slice(2);
const katex = require(source);

const PLACE = /<(span|div) class="arithmatex">\\([([])([\s\S]*?)\\[)\]]<\/\1>/g;
const PLAIN = {"&lt;": "<", "&gt;": ">", "&quot;": '"', "&#39;": "'", "&amp;": "&"};

function typeset(page) {
  const text = fs.readFileSync(page, "utf8");
  if (!text.includes('class="arithmatex"')) return 0;
  let count = 0;
  const done = text.replace(PLACE, (_, tag, bracket, escaped) => {
    const tex = escaped.replace(/&(?:lt|gt|quot|#39|amp);/g, (entity) => PLAIN[entity]);
    try {
      ++count;
      return `<${tag} class="equation">` +
        katex.renderToString(tex, {displayMode: bracket === "[", throwOnError: true, strict: "error"}) +
        `</${tag}>`;
    } catch (fault) {
      console.error(`${path.relative(site, page)}: ${fault.message}\n${tex}`);
      process.exit(1);
    }
  });
  if (done.includes('class="arithmatex"')) {
    console.error(`${path.relative(site, page)}: an equation was not found again`);
    process.exit(1);
  }
  fs.writeFileSync(page, done);
  return count;
}

let count = 0;
for (const entry of fs.readdirSync(site, {recursive: true})) {
  if (entry.endsWith(".html")) count += typeset(path.join(site, entry));
}
const from = path.dirname(source);
const to = path.join(site, "katex");
fs.mkdirSync(path.join(to, "fonts"), {recursive: true});
fs.copyFileSync(path.join(from, "katex.min.css"), path.join(to, "katex.min.css"));
for (const font of fs.readdirSync(path.join(from, "fonts"))) {
  // The first of the three forms that the style names; every browser takes it.
  if (font.endsWith(".woff2")) {
    fs.copyFileSync(path.join(from, "fonts", font), path.join(to, "fonts", font));
  }
}
if (count === 0) {
  console.error("no equation was typeset");
  process.exit(1);
}
