// SPDX-License-Identifier: MIT
// qpu-stats GPU < PAIRS        measures many programs, a table to standard output
// qpu-stats GPU VERT FRAG      prints what the driver says of one
//
// What Mesa's own compilers for the Raspberry Pi's GPUs make of GLSL ES programs. GPU is vc4 (Pi 0-3), v3d42
// (Pi 4) or v3d71 (Pi 5). The drivers run on Mesa's no-op DRM shims: they believe in a GPU, compile, and
// submit work to nobody. They report figures as KHR_debug messages. Each program is drawn with, because the
// drivers compile once more at the first draw, when formats and blending are known.
//
// PAIRS has a line a program: name, vertex shader's file, fragment shader's file, and "opaque" or "blend",
// separated by tabs. The table has a row a shader: GPU, name, stage (fragment, vertex, coordinate),
// instructions, threads, uniforms, temps, spills, fills; or the stage "error" and a message. Exits with 0
// where all was tried, with 2 where the driver could not be started.
//
// Expects ../lib beside the directory of this program: the toolchain's Mesa.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>
#include <gbm.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr char kPrepared[] = "QPU_STATS_PREPARED";

void fail(const std::string& what) {
    std::fprintf(stderr, "qpu-stats: %s\n", what.c_str());
    std::exit(2);
}

// The dynamic linker has to see the shim, so the program starts itself again in the GPU's environment.
void enterEnvironment(const std::string& gpu, char** argv) {
    if (std::getenv(kPrepared))
        return;
    if (gpu != "vc4" && gpu != "v3d42" && gpu != "v3d71")
        fail("the GPU is vc4, v3d42 or v3d71, not '" + gpu + "'");
    std::array<char, PATH_MAX> self{};
    if (readlink("/proc/self/exe", self.data(), self.size() - 1) < 0)
        fail("/proc/self/exe cannot be read");
    std::string library = self.data();
    library.erase(library.rfind('/'));
    library += "/../lib";
    const std::string driver = gpu.substr(0, 3);
    const auto set = [](const char* name, const std::string& value) { setenv(name, value.c_str(), 1); };
    set(kPrepared, "1");
    set("LD_LIBRARY_PATH", library);
    set("LD_PRELOAD", library + "/lib" + driver + "_noop_drm_shim.so");
    set("GBM_BACKENDS_PATH", library + "/gbm");
    set("MESA_LOADER_DRIVER_OVERRIDE", driver);
    set("MESA_SHADER_CACHE_DISABLE", "true");
    if (driver == "vc4")
        set("VC4_DEBUG", "shaderdb");
    if (gpu == "v3d71")
        set("V3D_SHIM_VER", "71");
    execv(self.data(), argv);
    fail("cannot start itself again");
}

// Takes standard error into memory: that is where vc4 says that it found no registers.
class ErrorCapture {
public:
    ErrorCapture() : m_memory(memfd_create("stderr", 0)), m_saved(dup(STDERR_FILENO)) {
        dup2(m_memory, STDERR_FILENO);
    }
    ~ErrorCapture() {
        dup2(m_saved, STDERR_FILENO);
        close(m_saved);
        close(m_memory);
    }
    ErrorCapture(const ErrorCapture&) = delete;
    ErrorCapture& operator=(const ErrorCapture&) = delete;

    std::string text() const {
        const off_t size = lseek(m_memory, 0, SEEK_END);
        std::string result(static_cast<std::size_t>(size), '\0');
        const ssize_t got = pread(m_memory, result.data(), result.size(), 0);
        result.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
        return result;
    }

private:
    int m_memory, m_saved;
};

class Display {
public:
    Display() {
        const int node = open("/dev/dri/renderD128", O_RDWR);
        gbm_device* device = node < 0 ? nullptr : gbm_create_device(node);
        if (!device)
            fail("the no-op DRM shim does not work");
        m_display = eglGetPlatformDisplay(EGL_PLATFORM_GBM_KHR, device, nullptr);
        if (!eglInitialize(m_display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_ES_API))
            fail("EGL does not start");
    }
    EGLDisplay get() const { return m_display; }

private:
    EGLDisplay m_display = EGL_NO_DISPLAY;
};

// A context for each program: v3d's would remember compiled shaders and not report them again.
class Context {
public:
    explicit Context(const Display& display) : m_display(display.get()) {
        constexpr EGLint kVersion[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
        m_context = eglCreateContext(m_display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kVersion);
        if (!eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
            fail("no context");
        const auto callback = reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKKHRPROC>(
            eglGetProcAddress("glDebugMessageCallbackKHR"));
        glEnable(GL_DEBUG_OUTPUT_KHR);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR);
        callback(&Context::receive, this);
    }
    ~Context() {
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(m_display, m_context);
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    std::vector<std::string> messages;

private:
    static void GL_APIENTRY receive(GLenum, GLenum, GLuint, GLenum, GLsizei length, const GLchar* text,
                                    const void* self) {
        auto* context = static_cast<Context*>(const_cast<void*>(self));
        context->messages.emplace_back(text, static_cast<std::size_t>(length));
    }

    EGLDisplay m_display;
    EGLContext m_context;
};

struct Pair {
    std::string name, vertexFile, fragmentFile;
    bool blend = false;
};

// What the driver said of a pair, or why it said nothing.
struct Outcome {
    std::vector<std::string> messages;
    std::string error;
};

std::string firstLine(const std::string& text) {
    std::string line = text.substr(0, text.find('\n'));
    for (char& c : line)
        c = c == '\t' ? ' ' : c;
    return line;
}

GLuint compile(GLenum type, const std::string& file, std::string& error) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    const std::string source = text.str();
    const char* pointer = source.c_str();
    const GLuint shader = glCreateShader(type);
    glShaderSource(shader, 1, &pointer, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (!done) {
        std::array<char, 4096> log{};
        glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
        error = "does not compile: " + file + ": " + firstLine(log.data());
    }
    return shader;
}

GLuint link(const Pair& pair, std::string& error) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, pair.vertexFile, error));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, pair.fragmentFile, error));
    glLinkProgram(program);
    GLint done = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done && error.empty()) {
        std::array<char, 4096> log{};
        glGetProgramInfoLog(program, log.size(), nullptr, log.data());
        error = "does not link: " + firstLine(log.data());
    }
    return program;
}

constexpr GLsizei kSize = 256;

GLuint texture(GLenum target) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    const bool cube = target == GL_TEXTURE_CUBE_MAP;
    for (GLenum face = 0; face < (cube ? 6U : 1U); ++face)
        glTexImage2D((cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target) + face, 0, GL_RGBA, kSize, kSize, 0,
                     GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    return name;
}

// 8 bits a colour channel and a depth buffer that is tested and written: what a model is drawn to.
void bindTarget() {
    GLuint frame = 0, depth = 0;
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture(GL_TEXTURE_2D), 0);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, kSize, kSize);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    glEnable(GL_DEPTH_TEST);
}

void bindSamplers(GLuint program) {
    GLint count = 0, unit = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        std::array<char, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, i, name.size(), nullptr, &size, &type, name.data());
        if (type != GL_SAMPLER_2D && type != GL_SAMPLER_CUBE)
            continue;
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        texture(type == GL_SAMPLER_CUBE ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D);
        glUniform1i(glGetUniformLocation(program, name.data()), unit++);
    }
}

void bindAttributes(GLuint program) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, 3 * 4 * sizeof(float), nullptr, GL_STATIC_DRAW);
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_ATTRIBUTES, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        std::array<char, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveAttrib(program, i, name.size(), nullptr, &size, &type, name.data());
        const GLint location = glGetAttribLocation(program, name.data());
        if (location < 0)
            continue;
        const GLint components = type == GL_FLOAT_VEC4   ? 4
                                 : type == GL_FLOAT_VEC3 ? 3
                                 : type == GL_FLOAT_VEC2 ? 2
                                                         : 1;
        glEnableVertexAttribArray(static_cast<GLuint>(location));
        glVertexAttribPointer(static_cast<GLuint>(location), components, GL_FLOAT, GL_FALSE,
                              4 * sizeof(float), nullptr);
    }
}

void draw(GLuint program, bool blend) {
    bindTarget();
    glViewport(0, 0, kSize, kSize);
    glUseProgram(program);
    bindSamplers(program);
    bindAttributes(program);
    if (blend) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
}

// The last word on a stage: drivers compile when linking, for a state that they guess, and once more at the
// draw where they guessed wrong.
std::string lastAbout(const std::vector<std::string>& messages, const std::string& stage) {
    std::string last;
    for (const std::string& message : messages)
        if (message.starts_with("MESA_SHADER_" + stage + " shader"))
            last = message;
    return last;
}

Outcome measure(const Display& display, const Pair& pair) {
    const ErrorCapture errors;
    Outcome outcome;
    Context context(display);
    const GLuint program = link(pair, outcome.error);
    if (!outcome.error.empty())
        return outcome;
    draw(program, pair.blend);
    outcome.messages = context.messages;
    const std::string said = errors.text();
    if (said.find("Failed to register allocate") != std::string::npos)
        outcome.error = "out of registers";
    else if (lastAbout(outcome.messages, "FRAGMENT").empty() || lastAbout(outcome.messages, "VERTEX").empty())
        outcome.error = "no figures: " + firstLine(said);
    return outcome;
}

// 0 where the driver does not say: vc4 never spills.
std::string figure(const std::string& message, const char* pattern) {
    std::smatch match;
    return std::regex_search(message, match, std::regex(pattern)) ? match[1].str() : "0";
}

void printRow(const std::string& begin, const char* stage, const std::string& message) {
    constexpr const char* kFigures[] = {"(\\d+) inst",      "(\\d+) threads",     "(\\d+) uniforms",
                                        "(\\d+) max-temps", "(\\d+):\\d+ spills", "\\d+:(\\d+) spills"};
    std::cout << begin << stage;
    for (const char* pattern : kFigures)
        std::cout << '\t' << figure(message, pattern);
    std::cout << '\n';
}

void printRows(const std::string& gpu, const std::string& name, const Outcome& outcome) {
    const std::string begin = gpu + '\t' + name + '\t';
    if (!outcome.error.empty()) {
        std::cout << begin << "error\t" << outcome.error << std::endl;
        return;
    }
    const std::string coordinate = gpu == "vc4" ? "COORD" : "VERTEX_BIN";
    printRow(begin, "fragment", lastAbout(outcome.messages, "FRAGMENT"));
    printRow(begin, "vertex", lastAbout(outcome.messages, "VERTEX"));
    printRow(begin, "coordinate", lastAbout(outcome.messages, coordinate));
    std::cout.flush();
}

bool readPair(std::istream& in, Pair& pair) {
    std::string line, blend;
    if (!std::getline(in, line))
        return false;
    std::istringstream columns(line);
    std::getline(columns, pair.name, '\t');
    std::getline(columns, pair.vertexFile, '\t');
    std::getline(columns, pair.fragmentFile, '\t');
    std::getline(columns, blend, '\t');
    pair.blend = blend == "blend";
    return true;
}

Display openDisplay() {
    const ErrorCapture chatter;
    return {};
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2 && argc != 4)
        fail("usage: qpu-stats vc4|v3d42|v3d71 [VERT FRAG]");
    const std::string gpu = argv[1];
    enterEnvironment(gpu, argv);
    const Display display = openDisplay();
    if (argc == 4) {
        const Outcome outcome = measure(display, {"", argv[2], argv[3]});
        for (const std::string& message : outcome.messages)
            std::cout << message << '\n';
        if (!outcome.error.empty())
            std::cout << outcome.error << '\n';
        return outcome.error.empty() ? 0 : 1;
    }
    for (Pair pair; readPair(std::cin, pair);)
        printRows(gpu, pair.name, measure(display, pair));
    return 0;
}
