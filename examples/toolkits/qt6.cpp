// SPDX-License-Identifier: MIT
// toolkit_qt6 MODEL [PICTURE.png...]: a model on what a QPainter draws, and text of another one over it. A
// drag turns the model; the wheel sets the sun. Writes a frame for each picture that is named, and leaves.
#include "model_view.h"

#include <QtGui/QMouseEvent>
#include <QtGui/QOpenGLContext>
#include <QtGui/QPainter>
#include <QtGui/QSurfaceFormat>
#include <QtGui/QWheelEvent>
#include <QtOpenGLWidgets/QOpenGLWidget>
#include <QtWidgets/QApplication>

#include <iostream>

using namespace franken;

namespace {

class ModelWidget : public QOpenGLWidget {
public:
    explicit ModelWidget(std::filesystem::path model) : m_model(std::move(model)) {}
    ~ModelWidget() override;

    const Result<void>& result() const { return m_result; } // Of the last thing that was done.

protected:
    void initializeGL() override;
    void paintGL() override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void release();
    Result<void> drawModel();

    std::filesystem::path m_model;
    std::unique_ptr<ModelView> m_view;
    Result<void> m_result;
    QPointF m_mouse;
    QMetaObject::Connection m_contextEnds;
};

ModelWidget::~ModelWidget() {
    disconnect(m_contextEnds);
    release();
}

void ModelWidget::release() {
    makeCurrent(); // The view deletes its GL objects.
    m_view.reset();
    doneCurrent();
}

// Once for each context: a widget that moves to another window gets a new one.
void ModelWidget::initializeGL() {
    const auto getProcAddress = [](const char* name) {
        return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
    };
    m_contextEnds = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
    Result<std::unique_ptr<ModelView>> view = ModelView::open(getProcAddress, m_model);
    if (view)
        m_view = *std::move(view);
    else
        m_result = view.error();
}

// Widgets count in device-independent pixels, GL in those of the screen.
Result<void> ModelWidget::drawModel() {
    return m_view->draw({.framebuffer = defaultFramebufferObject(),
                         .width = qRound(width() * devicePixelRatio()),
                         .height = qRound(height() * devicePixelRatio()),
                         .clear = Clear::Depth});
}

void ModelWidget::paintGL() {
    QLinearGradient dusk(0, 0, 0, height());
    dusk.setColorAt(0, QColor(0, 30, 90));
    dusk.setColorAt(1, QColor(230, 120, 60));
    QPainter(this).fillRect(rect(), dusk); // Ends at once: Qt's draws come first.

    if (m_view)
        m_result = drawModel();

    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 255, 128));
    painter.drawRoundedRect(QRect(10, height() - 50, width() - 20, 40), 8, 8);
    painter.setPen(Qt::white);
    const float sun = m_view ? m_view->sun() : 0;
    painter.drawText(QRect(10, height() - 50, width() - 20, 40), Qt::AlignCenter,
                     QString("%1, %2 lx").arg(QString::fromStdString(m_model.filename().string())).arg(sun));
}

void ModelWidget::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - std::exchange(m_mouse, event->position());
    if (m_view && event->buttons() != Qt::NoButton)
        m_view->drag(moved.x() / height(), moved.y() / height());
    update();
}

void ModelWidget::wheelEvent(QWheelEvent* event) {
    if (m_view)
        m_view->setSun(m_view->sun() + static_cast<float>(event->angleDelta().y()) / 240);
    update();
}

int run(int argc, char** argv) {
    QSurfaceFormat format; // Before the application, for all contexts that share objects.
    format.setRenderableType(QSurfaceFormat::OpenGLES);
    format.setVersion(2, 0);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    ModelWidget widget(argv[1]);
    widget.setMouseTracking(true);
    widget.resize(320, 240);
    widget.show();
    bool good = true;
    for (int i = 2; i < argc && good; ++i)
        good = widget.grabFramebuffer().save(argv[i]) && widget.result();
    const int code = argc == 2 ? application.exec() : 0;
    if (!widget.result())
        std::cerr << "toolkit_qt6: " << toString(widget.result().error()) << "\n";
    return good ? code : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc >= 2)
        return run(argc, argv);
    std::cerr << "usage: toolkit_qt6 MODEL [PICTURE.png...]\n";
    return 2;
}
