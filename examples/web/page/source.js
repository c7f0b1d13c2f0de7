// SPDX-License-Identifier: MIT
// The shaders' texts: highlighted, with what is new marked, and where each line comes from.

const kPattern = new RegExp([
  "(?<comment>//.*)",
  "(?<word>#.*|\\b(?:attribute|const|discard|else|for|highp|if|in|inout|lowp|mediump|out|precision|return|struct|uniform|varying)\\b)",
  "(?<type>\\b(?:bool|float|int|mat[234]|sampler2D|samplerCube|void|[bi]?vec[234])\\b)",
  "(?<number>\\b\\d+(?:\\.\\d*)?(?:e[+-]?\\d+)?)",
  "(?<function>\\b\\w+(?=\\())",
].join("|"), "g");

function* pieces(line) {
  let at = 0;
  for (const match of line.matchAll(kPattern)) {
    yield [null, line.slice(at, match.index)];
    const [kind] = Object.entries(match.groups).find(([, text]) => text !== undefined);
    yield [kind, match[0]];
    at = match.index + match[0].length;
  }
  yield [null, line.slice(at)];
}

function highlighted(line) {
  const item = document.createElement("li");
  for (const [kind, text] of pieces(line)) {
    if (!kind) {
      item.append(text);
      continue;
    }
    const span = document.createElement("span");
    span.className = kind;
    span.textContent = text;
    item.append(span);
  }
  return item;
}

/** Which lines of `after` are not in a longest common subsequence with `before`: comments do not count. */
export function newLines(before, after) {
  const lengths = Array.from({ length: before.length + 1 }, () => new Uint16Array(after.length + 1));
  for (let i = before.length - 1; i >= 0; --i)
    for (let j = after.length - 1; j >= 0; --j)
      lengths[i][j] = before[i] === after[j] ? lengths[i + 1][j + 1] + 1 : Math.max(lengths[i + 1][j], lengths[i][j + 1]);
  const isNew = after.map(() => true);
  for (let i = 0, j = 0; i < before.length && j < after.length;)
    if (before[i] === after[j]) {
      isNew[j] = false;
      ++i;
      ++j;
    } else if (lengths[i + 1][j] >= lengths[i][j + 1]) {
      ++i;
    } else {
      ++j;
    }
  return isNew.map((is, line) => is && !after[line].startsWith("//"));
}

/** The comments of a snippet's file, which name its papers. */
async function commentsOf(file) {
  const answer = await fetch(file.replace("generator/", ""));
  if (!answer.ok)
    return "";
  return (await answer.text()).split("\n").filter((line) => /^\/\/ (?!SPDX)/.test(line)).join("\n");
}

export class SourceView {
  constructor(list, originBox) {
    this.list = list;
    this.originBox = originBox;
    this.previous = null;
    this.chosen = 0;
    list.addEventListener("mouseover", (event) => this.choose([...list.children].indexOf(event.target.closest("li"))));
    list.addEventListener("keydown", (event) => this.onKey(event));
  }

  show(stage) {
    const lines = stage.text.replace(/\n$/, "").split("\n");
    const isNew = this.previous ? newLines(this.previous, lines) : lines.map(() => false);
    this.previous = lines;
    this.origins = stage.lines;
    this.list.replaceChildren(...lines.map((line, i) => {
      const item = highlighted(line);
      item.classList.toggle("new", isNew[i]);
      return item;
    }));
  }

  onKey(event) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step)
      return;
    event.preventDefault();
    this.choose(this.chosen + step);
    this.list.children[this.chosen].scrollIntoView({ block: "nearest" });
  }

  async choose(line) {
    if (line < 0 || line >= this.list.children.length)
      return;
    this.list.children[this.chosen]?.classList.remove("chosen");
    this.chosen = line;
    this.list.children[line].classList.add("chosen");
    const { origin, why } = this.origins[line];
    if (!origin) {
      this.originBox.textContent = `Line ${line + 1}: the composer wrote it.`;
      return;
    }
    const needed = why ? `, because of ${why}` : ", in every program of its kind";
    this.originBox.textContent = `Line ${line + 1}: ${origin}${needed}.`;
    const comments = await commentsOf(origin.replace(/:\d+$/, ""));
    if (this.chosen !== line || !comments)
      return;
    const text = document.createElement("pre");
    text.textContent = comments;
    this.originBox.append(text);
  }
}
