// SPDX-License-Identifier: MIT
// The block for Qt 6 of examples/toolkits/README.md, compiled. The example beside it is drawn.
#include "franken/renderer.h"

#include <QtGui/QPainter>
#include <QtOpenGLWidgets/QOpenGLWidget>

void report(const franken::Result<void>& result);

class ModelWidget : public QOpenGLWidget {
protected:
#include "blocks/examples/toolkits/qt-6.inc"

private:
    std::unique_ptr<franken::Renderer> m_renderer;
    franken::Viewpoint m_viewpoint;
};

static_assert(!std::is_abstract_v<ModelWidget>);
