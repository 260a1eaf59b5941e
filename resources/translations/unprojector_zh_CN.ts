<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Answers</name>
    <message>
        <source>%1: the pixel’s left edge. Its centre is half a pixel to the right.</source>
        <translation>%1：这是像素的左边缘。其中心还要向右半个像素。</translation>
    </message>
    <message>
        <source>%1: the pixel’s right edge. Its centre is half a pixel to the left.</source>
        <translation>%1：这是像素的右边缘。其中心还要向左半个像素。</translation>
    </message>
    <message>
        <source>%1: the pixel’s upper edge. Its centre is half a pixel lower.</source>
        <translation>%1：这是像素的上边缘。其中心还要低半个像素。</translation>
    </message>
    <message>
        <source>%1: the pixel’s lower edge. Its centre is half a pixel higher.</source>
        <translation>%1：这是像素的下边缘。其中心还要高半个像素。</translation>
    </message>
    <message>
        <source>%1: the row above. Rows count from 0, so the last one is %2.</source>
        <translation>%1：这是上面一行。行从 0 数起，所以最后一行是 %2。</translation>
    </message>
    <message>
        <source>%1: the centre of the pixel. Its row is a whole number.</source>
        <translation>%1：这是像素的中心。行号是整数。</translation>
    </message>
    <message>
        <source>%1 counts from the top. OpenGL counts from the bottom of the view, which is %2 high.</source>
        <translation>%1 是从上边数起的。OpenGL 从视图的下边数起，视图高 %2。</translation>
    </message>
    <message>
        <source>%1 counts from the bottom. The mouse counts from the top of the view, which is %2 high.</source>
        <translation>%1 是从下边数起的。鼠标从视图的上边数起，视图高 %2。</translation>
    </message>
    <message>
        <source>%1 is %2 times too large. That is the pixel ratio: the pixels here are device pixels already.</source>
        <translation>%1 大了 %2 倍。这正是像素比：这里已经是设备像素。</translation>
    </message>
    <message>
        <source>%1 is %2 times too small. That is the pixel ratio: the pixels here are device pixels.</source>
        <translation>%1 小了 %2 倍。这正是像素比：这里是设备像素。</translation>
    </message>
    <message>
        <source>%1 has the wrong sign. The eye looks along −z: what lies in front of it has a negative z.</source>
        <translation>%1 的符号不对。视点沿 −z 方向看：它前方的点 z 为负。</translation>
    </message>
    <message>
        <source>%1 has the wrong sign. Try again, or have it shown.</source>
        <translation>%1 的符号不对。请再试一次，或查看答案。</translation>
    </message>
    <message>
        <source>%1 comes out with near and far swapped. Near is %2, far is %3.</source>
        <translation>把近平面和远平面弄反了，才会得到 %1。近平面为 %2，远平面为 %3。</translation>
    </message>
    <message>
        <source>%1 is z in NDC, from −1 to 1. The depth goes from %2 to %3.</source>
        <translation>%1 是 NDC 的 z，范围为 −1 到 1。深度的范围为 %2 到 %3。</translation>
    </message>
    <message>
        <source>%1 comes out when z in NDC, from −1 to 1, is used as the depth.</source>
        <translation>把 NDC 的 z（−1 到 1）当作深度，才会得到 %1。</translation>
    </message>
    <message>
        <source>%1 is the depth, from %2 to %3. In NDC z goes from −1 to 1.</source>
        <translation>%1 是深度，范围为 %2 到 %3。NDC 的 z 范围为 −1 到 1。</translation>
    </message>
    <message>
        <source>%1 comes out when the depth is used as z in NDC, from −1 to 1.</source>
        <translation>把深度当作 NDC 的 z（−1 到 1），才会得到 %1。</translation>
    </message>
    <message>
        <source>%1 comes out on an even scale. A perspective gives most depths to what is close.</source>
        <translation>按均匀刻度才会得到 %1。透视投影把大部分深度值给了近处。</translation>
    </message>
    <message>
        <source>%1 comes out when degrees are taken for radians.</source>
        <translation>把度当作弧度，才会得到 %1。</translation>
    </message>
    <message>
        <source>%1 comes out when radians are taken for degrees.</source>
        <translation>把弧度当作度，才会得到 %1。</translation>
    </message>
    <message>
        <source>%1 is not it. Try again, or have it shown.</source>
        <translation>%1 不对。请再试一次，或查看答案。</translation>
    </message>
    <message>
        <source>Answer first; then the panel opens.</source>
        <translation>请先作答，面板随后打开。</translation>
    </message>
    <message>
        <source>The panel opens with the answer to step %1.</source>
        <translation>第 %1 步作答后，面板打开。</translation>
    </message>
    <message>
        <source>The end of the lesson</source>
        <translation>本课结束</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Right with the first answer</source>
        <translation>第一次就答对</translation>
    </message>
    <message>
        <source>Right with a later answer</source>
        <translation>后来答对</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>查看了答案</translation>
    </message>
    <message>
        <source>Not answered</source>
        <translation>未作答</translation>
    </message>
    <message>
        <source>Next lesson: &lt;b&gt;%1&lt;/b&gt;</source>
        <translation>下一课：&lt;b&gt;%1&lt;/b&gt;</translation>
    </message>
</context>
<context>
    <name>BundledNames</name>
    <message>
        <source>Teapot</source>
        <translation>茶壶</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>立方体</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>圆锥</translation>
    </message>
    <message>
        <source>Cube of side 10</source>
        <translation>边长为 10 的立方体</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>头部</translation>
    </message>
    <message>
        <source>Cube at 5</source>
        <translation>距离 5 处的立方体</translation>
    </message>
    <message>
        <source>Cube at 11</source>
        <translation>距离 11 处的立方体</translation>
    </message>
    <message>
        <source>Cube at 19</source>
        <translation>距离 19 处的立方体</translation>
    </message>
    <message>
        <source>MC, with the point (1, 1)</source>
        <translation>MC 与点 (1, 1)</translation>
    </message>
    <message>
        <source>MC, with the point (1, 1, 0)</source>
        <translation>MC 与点 (1, 1, 0)</translation>
    </message>
    <message>
        <source>Plate and outline</source>
        <translation>平板与轮廓</translation>
    </message>
    <message>
        <source>Triangle fan</source>
        <translation>三角形扇</translation>
    </message>
    <message>
        <source>Circle of radius 5</source>
        <translation>半径为 5 的圆</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>线段</translation>
    </message>
    <message>
        <source>Quad</source>
        <translation>四边形</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>立柱</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>平板</translation>
    </message>
    <message>
        <source>The point</source>
        <translation>点本身</translation>
    </message>
    <message>
        <source>Its projection</source>
        <translation>它的投影</translation>
    </message>
</context>
<context>
    <name>CopyMenu</name>
    <message>
        <source>&amp;Copy %1</source>
        <translation>复制 %1(&amp;C)</translation>
    </message>
    <message>
        <source>Copy %1 as &amp;text</source>
        <translation>将 %1 复制为文本(&amp;T)</translation>
    </message>
    <message>
        <source>Copy %1 as C &amp;array</source>
        <translation>将 %1 复制为 C 数组(&amp;A)</translation>
    </message>
    <message>
        <source>Copy %1 as &amp;GLM</source>
        <translation>将 %1 复制为 GLM(&amp;G)</translation>
    </message>
    <message>
        <source>Copy %1 as &amp;NumPy</source>
        <translation>将 %1 复制为 NumPy(&amp;N)</translation>
    </message>
    <message>
        <source>Copy %1 as &amp;LaTeX</source>
        <translation>将 %1 复制为 LaTeX(&amp;L)</translation>
    </message>
    <message>
        <source>Copy %1 as C&amp;SV</source>
        <translation>将 %1 复制为 CSV(&amp;S)</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>%1: %2</source>
        <comment>a file: the message about it</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Models and scenes (%1)</source>
        <translation>模型和场景 (%1)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <translation>模型 (%1)</translation>
    </message>
    <message>
        <source>The field is empty. Type a number.</source>
        <translation>没有输入数；请输入一个数。</translation>
    </message>
    <message>
        <source>“%1” ends where a number is expected. Complete it.</source>
        <translation>“%1”的末尾缺少一个数。</translation>
    </message>
    <message>
        <source>“%1”: a number is missing before “%2” (character %3).</source>
        <translation>“%1”：“%2”（第 %3 个字符）之前缺少一个数。</translation>
    </message>
    <message>
        <source>“%1”: a sign such as * or + is missing before “%2” (character %3).</source>
        <translation>“%1”：“%2”（第 %3 个字符）之前缺少 * 或 + 之类的运算符。</translation>
    </message>
    <message>
        <source>“%1” has a second decimal point (character %2); write thousands without a comma.</source>
        <translation>“%1”有第二个小数点（第 %2 个字符）；千位之间不要加逗号。</translation>
    </message>
    <message>
        <source>“%1” is not a number; type one such as 0.5, 1e-3, 1/3 or 2*pi.</source>
        <translation>“%1”不是数；请输入如 0.5、1e-3、1/3 或 2*pi 的数。</translation>
    </message>
    <message>
        <source>“%1”: “%2” (character %3) is not allowed here; use + - * / and parentheses.</source>
        <translation>“%1”：“%2”（第 %3 个字符）在此没有意义；可用 + - * / 和括号。</translation>
    </message>
    <message>
        <source>%1 needs its number in parentheses: %1(2).</source>
        <translation>%1 的数要写在括号里：%1(2)。</translation>
    </message>
    <message>
        <source>“%1”: the parenthesis at character %2 is not closed.</source>
        <translation>“%1”：第 %2 个字符处的括号没有闭合。</translation>
    </message>
    <message>
        <source>“%1”: the parenthesis at character %2 was never opened.</source>
        <translation>“%1”：第 %2 个字符处的括号没有对应的左括号。</translation>
    </message>
    <message>
        <source>“%1” divides by 0 (character %2).</source>
        <translation>“%1”除以了 0（第 %2 个字符）。</translation>
    </message>
    <message>
        <source>“%1” takes the root of a negative number.</source>
        <translation>“%1”对负数开平方。</translation>
    </message>
    <message>
        <source>%1 is too large or too small for a number here.</source>
        <translation>%1 太大或太小，无法作为数使用。</translation>
    </message>
    <message>
        <source>“%1” nests too many parentheses. Use fewer.</source>
        <translation>“%1”的括号嵌套过多。</translation>
    </message>
    <message>
        <source>“%1” can be read in two ways: type %2 or %3.</source>
        <translation>“%1”有两种读法：请输入 %2 或 %3。</translation>
    </message>
</context>
<context>
    <name>Formulas</name>
    <message>
        <source>The pixel&apos;s centre from the window&apos;s left edge, device pixels</source>
        <translation>像素中心到窗口左边的距离，设备像素</translation>
    </message>
    <message>
        <source>The pixel&apos;s centre from the window&apos;s upper edge, device pixels</source>
        <translation>像素中心到窗口上边的距离，设备像素</translation>
    </message>
    <message>
        <source>Height of the window, device pixels</source>
        <translation>窗口的高度，设备像素</translation>
    </message>
    <message>
        <source>Left edge of the viewport, device pixels</source>
        <translation>视口的左边，设备像素</translation>
    </message>
    <message>
        <source>Lower edge of the viewport, device pixels</source>
        <translation>视口的下边，设备像素</translation>
    </message>
    <message>
        <source>Width of the viewport, device pixels</source>
        <translation>视口的宽度，设备像素</translation>
    </message>
    <message>
        <source>Height of the viewport, device pixels</source>
        <translation>视口的高度，设备像素</translation>
    </message>
    <message>
        <source>Left edge of the projection window, eye units</source>
        <translation>投影窗口的左边，观察坐标单位</translation>
    </message>
    <message>
        <source>Right edge of the projection window, eye units</source>
        <translation>投影窗口的右边，观察坐标单位</translation>
    </message>
    <message>
        <source>Lower edge of the projection window, eye units</source>
        <translation>投影窗口的下边，观察坐标单位</translation>
    </message>
    <message>
        <source>Upper edge of the projection window, eye units</source>
        <translation>投影窗口的上边，观察坐标单位</translation>
    </message>
    <message>
        <source>Distance of the near plane, eye units</source>
        <translation>近平面的距离，观察坐标单位</translation>
    </message>
    <message>
        <source>Distance of the far plane, eye units</source>
        <translation>远平面的距离，观察坐标单位</translation>
    </message>
    <message>
        <source>Depth from the depth buffer, 0 at the near and 1 at the far plane</source>
        <translation>读出的深度，近平面为 0，远平面为 1</translation>
    </message>
    <message>
        <source>Distance of the point in front of the eye, eye units</source>
        <translation>该点在视点前方的距离，观察坐标单位</translation>
    </message>
    <message>
        <source>Distance of the point to the right of the eye, eye units</source>
        <translation>该点在视点右方的距离，观察坐标单位</translation>
    </message>
    <message>
        <source>Distance of the point above the eye, eye units</source>
        <translation>该点在视点上方的距离，观察坐标单位</translation>
    </message>
    <message>
        <source>Position of the eye, world units</source>
        <translation>视点的位置，世界单位</translation>
    </message>
    <message>
        <source>The eye&apos;s axis to the right, world space</source>
        <translation>视点指向右方的轴，世界空间</translation>
    </message>
    <message>
        <source>The eye&apos;s axis upwards, world space</source>
        <translation>视点指向上方的轴，世界空间</translation>
    </message>
    <message>
        <source>The eye&apos;s axis forwards, world space</source>
        <translation>视点指向前方的轴，世界空间</translation>
    </message>
    <message>
        <source>The point, world units</source>
        <translation>所求的点，世界单位</translation>
    </message>
    <message>
        <source>The point&apos;s x before the skew is undone, eye units</source>
        <translation>去除倾斜之前该点的 x，观察坐标单位</translation>
    </message>
    <message>
        <source>Shift of x per unit of y by the skew</source>
        <translation>倾斜使每单位 y 移动 x 的距离</translation>
    </message>
    <message>
        <source>The point in the box, before the shear, eye units</source>
        <translation>错切之前盒中的点，观察坐标单位</translation>
    </message>
    <message>
        <source>Shift by the shear per unit of z</source>
        <translation>错切使每单位 z 移动的距离</translation>
    </message>
    <message>
        <source>A point of the ray, world units</source>
        <translation>射线上的一点，世界单位</translation>
    </message>
    <message>
        <source>Fraction of the distance from the near to the far plane</source>
        <translation>从近平面到远平面的路程比例</translation>
    </message>
    <message>
        <source>Point where the ray enters the view volume, world units</source>
        <translation>射线进入视景体的位置，世界单位</translation>
    </message>
    <message>
        <source>Vector to the point where the ray leaves the view volume, world units</source>
        <translation>到射线离开视景体处的位移，世界单位</translation>
    </message>
    <message>
        <source>The ray enters the view volume at %1 and leaves it at %2.</source>
        <translation>射线在 %1 处进入视景体，在 %2 处离开。</translation>
    </message>
    <message>
        <source>Accuracy ±&#xa0;%1 along the view and ±&#xa0;%2&#xa0;×&#xa0;%3 across it (half of the %4 pixels that a point is drawn wide).</source>
        <translation>缓冲所允许的误差：沿视线方向 ±&#xa0;%1（半个深度级），垂直于视线方向 ±&#xa0;%2&#xa0;×&#xa0;%3（点画成 %4 像素宽，此为其一半）。</translation>
    </message>
    <message>
        <source>Accuracy ±&#xa0;%1 along the view (depth buffer alone ±&#xa0;%2). A pixel covers %3&#xa0;×&#xa0;%4 here.</source>
        <translation>沿视线方向的精度为 ±&#xa0;%1（仅深度缓冲为 ±&#xa0;%2）。此处一个像素覆盖 %3&#xa0;×&#xa0;%4。</translation>
    </message>
</context>
<context>
    <name>OpenGLCheck</name>
    <message>
        <source>Update the graphics driver. The opengl32sw.dll in the program&apos;s folder does not help; replace it with a newer one from Mesa.</source>
        <translation>请更新显卡驱动程序。程序文件夹中的 opengl32sw.dll 无济于事，请换用较新的 Mesa 版本。</translation>
    </message>
    <message>
        <source>Update the graphics driver. On a remote desktop or in a virtual machine, put Mesa&apos;s opengl32sw.dll into the program&apos;s folder.</source>
        <translation>请更新显卡驱动程序。若在远程桌面或虚拟机中，请把 Mesa 的 opengl32sw.dll 放入程序所在的文件夹。</translation>
    </message>
    <message>
        <source>Install or update the graphics driver. Without a graphics card, install Mesa (Debian, Ubuntu: libgl1-mesa-dri).</source>
        <translation>请安装或更新图形驱动程序。没有显卡时请安装 Mesa（Debian、Ubuntu：libgl1-mesa-dri）。</translation>
    </message>
    <message>
        <source>OpenGL is missing; the view needs OpenGL 3.3. %1</source>
        <translation>此处没有 OpenGL，而视图需要 OpenGL 3.3。%1</translation>
    </message>
    <message>
        <source>This computer has OpenGL %1.%2 (%3); the view needs 3.3. %4</source>
        <translation>此处的 OpenGL 版本为 %1.%2（%3），而视图需要 3.3。%4</translation>
    </message>
</context>
<context>
    <name>ProportionTexts</name>
    <message>
        <source>A circle is drawn as a circle.</source>
        <translation>圆画出来仍是圆。</translation>
    </message>
    <message>
        <source>A circle would be drawn %1 : 1, wider than high.</source>
        <translation>圆会画成 %1 : 1，宽大于高。</translation>
    </message>
    <message>
        <source>A circle would be drawn %1 : 1, higher than wide.</source>
        <translation>圆会画成 %1 : 1，高大于宽。</translation>
    </message>
</context>
<context>
    <name>RayTexts</name>
    <message>
        <source>The ray meets no mesh either.</source>
        <translation>射线也不与任何网格相交。</translation>
    </message>
    <message>
        <source>The ray takes the nearest point, within 8 pixels.</source>
        <translation>射线取 8 像素以内最近的点。</translation>
    </message>
    <message>
        <source>This setup has no ray.</source>
        <translation>此画面没有射线。</translation>
    </message>
    <message>
        <source>Point %1 of the cloud.</source>
        <translation>点云中的点 %1。</translation>
    </message>
    <message>
        <source>Snapped to vertex %1 of triangle %2.</source>
        <translation>所取：顶点 %1，属于三角形 %2。</translation>
    </message>
    <message>
        <source>Snapped to the nearest point of edge %1 to %2 of triangle %3.</source>
        <translation>所取：边 %1–%2 上最近的点，属于三角形 %3。</translation>
    </message>
    <message>
        <source>Snapped to face %1 in the plane %2.</source>
        <translation>所取：面 %1，所在平面 %2。</translation>
    </message>
    <message>
        <source>The ray meets nothing, %1 is drawn: its outline passes the pixel&apos;s centre, and the GPU draws edges to 1/256 pixel. Trust the formula.</source>
        <translation>绘出了 %1，射线却不与任何网格相交：其轮廓经过像素中心，而 GPU 绘制边只精确到 1/256 像素。应信公式。</translation>
    </message>
    <message>
        <source>The ray takes the nearest point, %1 from the formula, which has the pixel&apos;s centre. Trust the point: it is the file&apos;s.</source>
        <translation>射线取最近的点，与公式相差 %1（公式算的是像素中心）。应信该点：它就是文件中的点。</translation>
    </message>
    <message>
        <source>Vertex %1 of %2</source>
        <translation>“%2”的顶点 %1</translation>
    </message>
    <message>
        <source>Point %1 of %2</source>
        <translation>“%2”的点 %1</translation>
    </message>
    <message>
        <source>A point of edge %1–%2 of %3</source>
        <translation>“%3”的边 %1–%2 上的点</translation>
    </message>
    <message>
        <source>A point of face %1 of %2</source>
        <translation>“%2”的面 %1 上的点</translation>
    </message>
    <message>
        <source>The vertex is accurate to ± %1: its coordinate comes from the file. The table shows the clicked pixel.</source>
        <translation>所取顶点的可靠程度为 ± %1：它是文件中的顶点。表格是所点击像素的数值。</translation>
    </message>
    <message>
        <source>The point on the edge is accurate to ± %1: it does not use the depth buffer. The table shows the clicked pixel.</source>
        <translation>边上所取的点的可靠程度为 ± %1：它不经过深度缓冲。表格是所点击像素的数值。</translation>
    </message>
    <message>
        <source>The point on the face is accurate to ± %1: it does not use the depth buffer. The table shows the clicked pixel.</source>
        <translation>面上所取的点的可靠程度为 ± %1：它不经过深度缓冲。表格是所点击像素的数值。</translation>
    </message>
    <message>
        <source>Triangle %1, barycentric (%2, %3, %4); vertex %5 is %6 away, edge %7–%8 %9 away.</source>
        <translation>三角形 %1，重心坐标 (%2, %3, %4)；顶点 %5 距此 %6，边 %7–%8 距此 %9。</translation>
    </message>
    <message>
        <source>Exact hit: %1 from the formula, in depth steps %2. Trust the exact hit: it does not use the depth buffer.</source>
        <translation>精确交点：与公式相差 %1，合 %2 个深度级。应信精确交点：它不使用深度缓冲。</translation>
    </message>
    <message>
        <source>Exact hit: %1 behind the formula: an edge passes the pixel&apos;s centre, and the GPU draws edges to 1/256 pixel. Trust the exact hit.</source>
        <translation>精确交点：在公式结果之后 %1。一条边经过像素中心，而 GPU 绘制边只精确到 1/256 像素。应信精确交点。</translation>
    </message>
    <message>
        <source>Exact hit: %1 before the formula: an edge passes the pixel&apos;s centre, and the GPU draws edges to 1/256 pixel. Trust the exact hit.</source>
        <translation>精确交点：在公式结果之前 %1。一条边经过像素中心，而 GPU 绘制边只精确到 1/256 像素。应信精确交点。</translation>
    </message>
    <message>
        <source>The ray meets %1, %2 behind %3: an edge passes the pixel&apos;s centre, and the GPU draws edges to 1/256 pixel. Trust the exact hit.</source>
        <translation>射线与 %1 相交，在 %3 之后 %2：一条边经过像素中心，而 GPU 绘制边只精确到 1/256 像素。应信精确交点。</translation>
    </message>
    <message>
        <source>The ray meets %1, %2 before %3: an edge, or a sliver that the GPU leaves out. Trust the exact hit.</source>
        <translation>射线与 %1 相交，在 %3 之前 %2：那是一条边，或是 GPU 漏掉的狭长三角形。应信精确交点。</translation>
    </message>
    <message>
        <source>Two surfaces at one depth, %1 apart: %2 is drawn, the ray meets %3. Neither method shows which is in front; trust the exact hit&apos;s coordinates.</source>
        <translation>两个曲面在同一深度，相距 %1：绘出的是 %2，射线交于 %3。两种方法都看不出哪一个在前；请以精确交点的坐标为准。</translation>
    </message>
    <message>
        <source>The ray meets %1, nothing is drawn: an outline passes the pixel&apos;s centre, or a sliver that the GPU leaves out. Trust the exact hit.</source>
        <translation>什么也没有绘出，射线却与 %1 相交：轮廓经过像素中心，或是 GPU 漏掉的狭长三角形。应信精确交点。</translation>
    </message>
    <message>
        <source>The ray meets %1, nothing is drawn: the depth buffer rounds its depth to that of the far plane. Trust the exact hit, or move near and far closer together.</source>
        <translation>什么也没有绘出，射线却与 %1 相交：深度缓冲把它的深度舍入成了远平面的深度。应信精确交点，或使近、远平面靠近一些。</translation>
    </message>
    <message>
        <source>The exact hit comes as soon as the model is prepared for it.</source>
        <translation>模型准备好后，即给出精确交点。</translation>
    </message>
    <message>
        <source>There is no exact hit: %1.</source>
        <translation>无法给出精确交点：%1。</translation>
    </message>
    <message>
        <source>This pixel holds an edge of %1. The click is beside it.</source>
        <translation>这个像素内有 %1 的边缘。点击位于其旁边。</translation>
    </message>
    <message>
        <source>The ± is for the pixel&apos;s centre only.</source>
        <translation>± 只针对像素中心。</translation>
    </message>
    <message>
        <source>This pixel holds an edge of the surface: beside it is the background.</source>
        <translation>这个像素内有表面的边缘：旁边是背景。</translation>
    </message>
    <message>
        <source>This pixel holds an edge of the surface: %1 behind it lies %2.</source>
        <translation>这个像素内有表面的边缘：其后 %1 处是 %2。</translation>
    </message>
    <message>
        <source>This pixel holds an edge of the surface: %1 before it lies %2.</source>
        <translation>这个像素内有表面的边缘：其前 %1 处是 %2。</translation>
    </message>
</context>
<context>
    <name>SinceClickTexts</name>
    <message>
        <source>x &lt; −w: left of the view volume</source>
        <translation>x &lt; −w：在视景体左侧</translation>
    </message>
    <message>
        <source>x &gt; w: right of the view volume</source>
        <translation>x &gt; w：在视景体右侧</translation>
    </message>
    <message>
        <source>y &lt; −w: below the view volume</source>
        <translation>y &lt; −w：在视景体下方</translation>
    </message>
    <message>
        <source>y &gt; w: above the view volume</source>
        <translation>y &gt; w：在视景体上方</translation>
    </message>
    <message>
        <source>z &lt; −w: before the near plane</source>
        <translation>z &lt; −w：在近平面之前</translation>
    </message>
    <message>
        <source>z &gt; w: behind the far plane</source>
        <translation>z &gt; w：在远平面之后</translation>
    </message>
    <message>
        <source>w = 0: in the plane of the eye</source>
        <translation>w = 0：在视点所在平面内</translation>
    </message>
    <message>
        <source>w &lt; 0: behind the eye</source>
        <translation>w &lt; 0：在视点后方</translation>
    </message>
    <message>
        <source>The view has changed since this click. The point is outside it now: %1.</source>
        <translation>点击之后视图已改变。该点现在位于视图之外：%1。</translation>
    </message>
    <message>
        <source>The view has changed since this click; all numbers are those of the click.</source>
        <translation>点击之后视图已改变；所有数字都是点击时的。</translation>
    </message>
    <message>
        <source>The object was moved since this click; the point is where its surface was.</source>
        <translation>点击之后物体已被移动；该点是其表面原来的位置。</translation>
    </message>
    <message>
        <source>The object of this click is hidden now.</source>
        <translation>这次点击的物体现已隐藏。</translation>
    </message>
    <message>
        <source>A clip plane cuts the point of this click away now.</source>
        <translation>这次点击的点现已被裁剪平面切去。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::AboutDialog</name>
    <message>
        <source>About Unprojector</source>
        <translation>关于 Unprojector</translation>
    </message>
    <message>
        <source>not started</source>
        <translation>尚未启动</translation>
    </message>
    <message>
        <source>Click a pixel of a 3-D view and get its world coordinate, computed twice: by the closed-form inverse formulas of Weng, Huang and Cai (2008) and by the inverted matrix. The window shows the difference, its cause and the uncertainty of the coordinate.</source>
        <translation>点击三维视图中的一个像素，得到它的世界坐标，用两种方法计算：Weng、Huang 与 Cai（2008）的逆变换解析公式，以及逆矩阵。窗口显示两者之差、其原因，以及坐标的不确定度。</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>MIT licence.</source>
        <translation>MIT 许可证。</translation>
    </message>
    <message>
        <source>&amp;Copy Versions</source>
        <translation>复制版本信息(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the versions, for a report</source>
        <translation>复制版本信息，供报告使用</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::AddedText</name>
    <message>
        <source>1 triangle</source>
        <translation>1 个三角形</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>%1 added: %2</source>
        <translation>已添加 %1：%2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>two sentences, the second with its full stop</extracomment>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>%1 models added: %2</source>
        <translation>已添加 %1 个模型：%2</translation>
    </message>
    <message>
        <source>%1 is %2 times as large as the rest. To see one object, choose Fit in the Objects panel.</source>
        <translation>%1 的大小是其余物体的 %2 倍：用“物体”面板中的“适合窗口”可分别查看。</translation>
    </message>
    <message>
        <source>The rest is %2 times as large as %1. To see one object, choose Fit in the Objects panel.</source>
        <translation>其余物体的大小是 %1 的 %2 倍：用“物体”面板中的“适合窗口”可分别查看。</translation>
    </message>
    <message>
        <source>The objects are so far apart that each looks like a dot. To see one, choose Fit in the Objects panel.</source>
        <translation>各物体相距太远，都只是小点：用“物体”面板中的“适合窗口”可分别查看。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::AnswerBlock</name>
    <message>
        <source>Chec&amp;k</source>
        <translation>检查(&amp;K)</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>显示(&amp;W)</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation>您的答案</translation>
    </message>
    <message>
        <source>A number or an expression such as 3/4 or 2*sqrt(2)</source>
        <translation>一个数或表达式，例如 3/4 或 2*sqrt(2)</translation>
    </message>
    <message>
        <source>Compare your answer with the program&apos;s</source>
        <translation>将您的答案与程序的答案比较</translation>
    </message>
    <message>
        <source>Show the answer and its explanation</source>
        <translation>显示答案及其原因</translation>
    </message>
    <message>
        <source>Verdict on your answer</source>
        <translation>您的答案是否正确</translation>
    </message>
    <message>
        <source>Right: %1.</source>
        <translation>正确：%1。</translation>
    </message>
    <message>
        <source>It is %1.</source>
        <translation>答案是 %1。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::AnswerView</name>
    <message>
        <source>Clicked object</source>
        <translation>点击的物体</translation>
    </message>
    <message>
        <source>World coordinate</source>
        <translation>世界坐标</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the coordinate with all digits; the arrow offers other forms</source>
        <translation>复制坐标的全部位数；其他形式见箭头</translation>
    </message>
    <message>
        <source>Copy to the last certain digit</source>
        <translation>复制到最后一个可靠位</translation>
    </message>
    <message>
        <source>Copy with ±</source>
        <translation>连同 ± 复制</translation>
    </message>
    <message>
        <source>Copy everything about this click</source>
        <translation>复制这次点击的全部内容</translation>
    </message>
    <message>
        <source>World units. The ± beside the point is the largest of the three; Why? has the ± along the view.
Grey digits are smaller than the uncertainty.</source>
        <translation>世界单位。点旁的 ± 是三个中最大的；沿视线的 ± 见“为什么？”。
灰色数字小于不确定度。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ApiClicksView</name>
    <message>
        <source>In other APIs</source>
        <translation>其他 API 中的表示</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>观察坐标</translation>
    </message>
    <message>
        <source>World</source>
        <translation>世界</translation>
    </message>
    <message>
        <source>Click a surface to see them.</source>
        <translation>点击曲面即可看到。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ApiText</name>
    <message>
        <source>The eye looks along −z, y up; NDC from −1 to 1; pixels from the bottom-left corner, y up, with their centres at halves.</source>
        <translation>视线沿 −z，y 向上；NDC 从 −1 到 1；像素从左下角起计，y 向上，像素中心在半整数处。</translation>
    </message>
    <message>
        <source>y of NDC points down, z goes from 0 to 1; pixels from the top-left corner. The projection is GLM&apos;s perspectiveRH_ZO with its second row negated.</source>
        <translation>NDC 的 y 向下，z 从 0 到 1；像素从左上角起计。投影为 GLM 的 perspectiveRH_ZO，第二行取负。</translation>
    </message>
    <message>
        <source>Row vectors; the eye looks along +z (XMMatrixPerspectiveFovLH); z of NDC from 0 to 1; pixels from the top-left corner. The world stays as it is, so the view mirrors z. Direct3D 10 and later: 9 has the centres of pixels at whole numbers.</source>
        <translation>行向量；视线沿 +z（XMMatrixPerspectiveFovLH）；NDC 的 z 从 0 到 1；像素从左上角起计。世界坐标保持不变，因此观察矩阵把 z 反向。指 Direct3D 10 及以后：Direct3D 9 的像素中心在整数处。</translation>
    </message>
    <message>
        <source>z of NDC from 0 to 1; pixels from the top-left corner, y down.</source>
        <translation>NDC 的 z 从 0 到 1；像素从左上角起计，y 向下。</translation>
    </message>
    <message>
        <source>Logical (CSS) pixels from the top-left corner, as in clientX and clientY; everything else as in OpenGL.</source>
        <translation>从左上角起计的逻辑（CSS）像素，与 clientX、clientY 相同；其余与 OpenGL 相同。</translation>
    </message>
    <message>
        <source>The world is left-handed: its z is negated. The camera&apos;s matrices are OpenGL&apos;s, pixels count from the bottom-left corner. The depth buffer is reversed, 1 at near (SystemInfo.usesReversedZBuffer; where Unity runs on OpenGL it is not).</source>
        <translation>世界坐标系为左手系：z 取负。相机矩阵与 OpenGL 相同，像素从左下角起计。深度缓冲反向，近平面为 1（SystemInfo.usesReversedZBuffer；Unity 在 OpenGL 上运行时不反向）。</translation>
    </message>
    <message>
        <source>x right, y down, z forward; pixels from the top-left corner with their centres at whole numbers. x / z and y / z replace NDC, z replaces the depth. No lens distortion.</source>
        <translation>x 向右，y 向下，z 向前；像素从左上角起计，像素中心在整数处；以 x / z、y / z 代替 NDC，以 z 代替深度。不含镜头畸变。</translation>
    </message>
    <message>
        <source>Row vectors, v · M; pixels from the top-left corner, y down.</source>
        <translation>行向量，v · M；像素从左上角起计，y 向下。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::CameraStep</name>
    <message>
        <source>&amp;Paste camera…</source>
        <translation>粘贴相机(&amp;P)…</translation>
    </message>
    <message>
        <source>Use curre&amp;nt view</source>
        <translation>使用当前视图(&amp;N)</translation>
    </message>
    <message>
        <source>The camera that counts</source>
        <translation>作为依据的相机</translation>
    </message>
    <message>
        <source>Setup of the pixels</source>
        <translation>像素所属的设置</translation>
    </message>
    <message>
        <source>Give the camera of your program: K, R, t, a camera&apos;s file, matrices, or calls</source>
        <translation>给出您的程序的相机：K、R、t，相机文件，矩阵或调用</translation>
    </message>
    <message>
        <source>Read the pixels in the current view</source>
        <translation>在当前视图中读取像素</translation>
    </message>
    <message>
        <source>Your camera</source>
        <translation>您的相机</translation>
    </message>
    <message>
        <source>More about your program</source>
        <translation>您的程序的其他情况</translation>
    </message>
    <message>
        <source>The size of its window, and another size that it may use by mistake</source>
        <translation>它的窗口大小，以及它可能仍在沿用的另一个大小</translation>
    </message>
    <message>
        <source>Its window</source>
        <translation>它的窗口</translation>
    </message>
    <message>
        <source>Device pixels, such as 1000 x 700. Empty: as large as the view</source>
        <translation>以设备像素计，例如 1000 x 700。留空：与视图一样大</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>另一个大小</translation>
    </message>
    <message>
        <source>Device pixels, such as 640 x 480: an earlier size of the window, or another framebuffer&apos;s</source>
        <translation>以设备像素计，例如 640 x 480：窗口以前的大小，或另一个帧缓冲的大小</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Its &amp;window:</source>
        <translation>它的窗口(&amp;W)：</translation>
    </message>
    <message>
        <source>Another &amp;size it may use:</source>
        <translation>可能沿用的另一个大小(&amp;S)：</translation>
    </message>
    <message>
        <source>The camera that you gave counts: its projection and its view.</source>
        <translation>以您给出的相机为准：它的投影和观察。</translation>
    </message>
    <message>
        <source>The projection that you gave counts, with this scene&apos;s view.</source>
        <translation>以您给出的投影为准，观察取自此场景。</translation>
    </message>
    <message>
        <source>The view that you gave counts, with this scene&apos;s projection.</source>
        <translation>以您给出的观察为准，投影取自此场景。</translation>
    </message>
    <message>
        <source>The camera with which the points were entered counts.</source>
        <translation>以录入这些点时的相机为准。</translation>
    </message>
    <message>
        <source>This scene&apos;s camera counts.</source>
        <translation>以此场景的相机为准。</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>透视投影</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>正投影</translation>
    </message>
    <message>
        <source>%1, near %2, far %3.</source>
        <comment>kind of projection</comment>
        <translation>%1，近 %2，远 %3。</translation>
    </message>
    <message>
        <source>as the view, %1</source>
        <translation>与视图相同，%1</translation>
    </message>
    <message>
        <source>The scene cannot be drawn in a window of %1.</source>
        <translation>在 %1 的窗口里，这个场景没有画面。</translation>
    </message>
    <message>
        <source>Pixels of %1, of the view when they were entered</source>
        <translation>像素属于给出它们时的视图，%1</translation>
    </message>
    <message>
        <source>Pixels of your program&apos;s window, %1</source>
        <translation>像素属于您的程序的窗口，%1</translation>
    </message>
    <message>
        <source>Pixels of the view, %1</source>
        <translation>像素属于视图，%1</translation>
    </message>
    <message>
        <source>Not used: %1</source>
        <translation>未采用：%1</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::CandidatesTable</name>
    <message>
        <source>Mistake</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Its answer</source>
        <translation>它给出的结果</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>位数</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>相差</translation>
    </message>
    <message>
        <source>Greatest difference of a coordinate, in units of the last given digit</source>
        <translation>以给出的末位为单位：各坐标之差中最大的</translation>
    </message>
    <message>
        <source>Number of given digits that the mistake explains</source>
        <translation>它能解释给出的多少位数字</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>候选</translation>
    </message>
    <message>
        <source>Mistakes that explain the point, the best first. The code to change belongs to the selected one</source>
        <translation>可能造成这个点的错误，最符合的在前。要改的代码是所选那一行的</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ClickFeature</name>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>点击</translation>
    </message>
    <message>
        <source>The view and the answer to a click</source>
        <translation>视图，以及一次点击得到的结果</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>表面(&amp;S)</translation>
    </message>
    <message>
        <source>A click picks the surface under the pointer</source>
        <translation>点击选取其下的表面</translation>
    </message>
    <message>
        <source>&amp;Vertex</source>
        <translation>顶点(&amp;V)</translation>
    </message>
    <message>
        <source>A click picks the visible vertex within 8 pixels, with its exact coordinate</source>
        <translation>点击选取 8 像素以内可见的顶点，给出其精确坐标</translation>
    </message>
    <message>
        <source>&amp;Edge</source>
        <translation>边(&amp;E)</translation>
    </message>
    <message>
        <source>A click picks the nearest point of a visible edge within 8 pixels</source>
        <translation>点击选取 8 像素以内可见的边上最近的点</translation>
    </message>
    <message>
        <source>&amp;Face</source>
        <translation>面(&amp;F)</translation>
    </message>
    <message>
        <source>A click picks the face under the pointer, with its plane</source>
        <translation>点击选取其下的面及其所在平面</translation>
    </message>
    <message>
        <source>Pick in Every Space</source>
        <translation>各空间中的拾取点</translation>
    </message>
    <message>
        <source>Snap To</source>
        <translation>捕捉到</translation>
    </message>
    <message>
        <source>Snap clicks to the surface, a vertex, an edge or a face</source>
        <translation>单击取网格上的什么</translation>
    </message>
    <message>
        <source>Snap: %1</source>
        <translation>捕捉：%1</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the coordinate of the pick with all its digits</source>
        <translation>复制拾取的坐标，含全部数位</translation>
    </message>
    <message>
        <source>There is no pick to copy. Click the model first.</source>
        <translation>没有可复制的拾取。请先点击模型。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ClipGroup</name>
    <message>
        <source>The plane keeps points with A x + B y + C z + D ≥ 0, in world coordinates.</source>
        <translation>在世界坐标中，保留 A x + B y + C z + D ≥ 0 的一侧。</translation>
    </message>
    <message>
        <source>Add plane</source>
        <translation>添加平面</translation>
    </message>
    <message>
        <source>Add a clip plane through the middle of the objects; six at most (glClipPlane)</source>
        <translation>添加一个通过物体中部的裁剪平面；最多六个 (glClipPlane)</translation>
    </message>
    <message>
        <source>Add clip plane</source>
        <translation>添加裁剪平面</translation>
    </message>
    <message>
        <source>Remove clip plane</source>
        <translation>移除裁剪平面</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1：</translation>
    </message>
    <message>
        <source>Plane %1 cuts</source>
        <translation>平面 %1 起作用</translation>
    </message>
    <message>
        <source>Switch this plane on or off (glEnable, glDisable)</source>
        <translation>此平面是否裁剪物体 (glEnable, glDisable)</translation>
    </message>
    <message>
        <source>Side of plane %1 that is kept</source>
        <translation>平面 %1 保留的一侧</translation>
    </message>
    <message>
        <source>Remove plane %1</source>
        <translation>移除平面 %1</translation>
    </message>
    <message>
        <source>Remove this plane</source>
        <translation>移除此平面</translation>
    </message>
    <message>
        <source>Clip plane on</source>
        <translation>启用裁剪平面</translation>
    </message>
    <message>
        <source>Clip plane off</source>
        <translation>停用裁剪平面</translation>
    </message>
    <message>
        <source>Clip plane %1</source>
        <translation>裁剪平面 %1</translation>
    </message>
    <message>
        <source>%1 of the plane A x + B y + C z + D = 0; (A, B, C) points to the side that is kept</source>
        <translation>平面 A x + B y + C z + D = 0 的 %1；(A, B, C) 指向保留的一侧</translation>
    </message>
    <message>
        <source>D of the plane A x + B y + C z + D = 0, world units where (A, B, C) has length 1</source>
        <translation>平面 A x + B y + C z + D = 0 的 D，(A, B, C) 长度为 1 时以世界单位计</translation>
    </message>
    <message>
        <source>Plane %1: %2</source>
        <translation>平面 %1：%2</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>裁剪平面</translation>
    </message>
    <message>
        <source>Planes that cut the objects (glClipPlane)</source>
        <translation>裁剪物体的平面 (glClipPlane)</translation>
    </message>
    <message>
        <source>No clip planes</source>
        <translation>没有裁剪平面</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::CodeChangesView</name>
    <message>
        <source>Lines for %1</source>
        <translation>%1 的代码</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>库</translation>
    </message>
    <message>
        <source>Code to change</source>
        <translation>要改的代码</translation>
    </message>
    <message>
        <source>Copy the lines before and after the change</source>
        <translation>复制原来的行和应有的行</translation>
    </message>
    <message>
        <source>%1: no line of this library causes it. Choose another library to see the line that does.</source>
        <translation>%1：这个库里没有哪一行会造成它；其他库的代码说明它出在哪里。</translation>
    </message>
    <message>
        <source>To change: %1</source>
        <translation>要改的：%1</translation>
    </message>
    <message>
        <source>Copy these &amp;lines</source>
        <translation>复制这几行(&amp;L)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ColorScale</name>
    <message>
        <source>Scale of the map</source>
        <translation>映射图的刻度</translation>
    </message>
    <message>
        <source>Logarithmic, from the first percentile to the maximum. Smaller values, also 0, have the darkest colour</source>
        <translation>对数刻度：从百分之一的像素低于的数到最大的数。更小的数，包括 0，用最深的颜色</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>从 %1 到 %2</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ComparisonModel</name>
    <message>
        <source>Near</source>
        <translation>近</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>公式</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>Closed-form formulas (9) to (12) in double precision</source>
        <translation>用解析公式 (9) 至 (12) 计算，double</translation>
    </message>
    <message>
        <source>Inverse of projection × view in double precision, as in gluUnProject</source>
        <translation>用“投影矩阵 × 观察矩阵”的逆矩阵计算，double，与 gluUnProject 相同</translation>
    </message>
    <message>
        <source>Formula minus matrix inverse</source>
        <translation>公式减逆矩阵</translation>
    </message>
    <message>
        <source>The difference in units in the last place of the point&apos;s largest component</source>
        <translation>差值，以该点最大分量的末位单位 (ulp) 计</translation>
    </message>
    <message>
        <source>The inverted matrix computed in single precision, as in many programs</source>
        <translation>用单精度求逆矩阵，许多程序都是这样做的</translation>
    </message>
    <message>
        <source>Formula minus the single-precision result</source>
        <translation>公式减单精度结果</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>矩阵</translation>
    </message>
    <message>
        <source>%1 ± %2
Grey digits are smaller than the uncertainty.</source>
        <translation>%1 ± %2
灰色数位小于不确定度。</translation>
    </message>
    <message>
        <source>in ulp</source>
        <translation>ulp 数</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>单精度</translation>
    </message>
    <message>
        <source>Formula − float</source>
        <translation>公式 − 单精度</translation>
    </message>
    <message>
        <source>Where the ray through the pixel&apos;s centre meets the mesh itself, in double, without the depth buffer</source>
        <translation>经过像素中心的射线与网格本身的交点，双精度，不经过深度缓冲</translation>
    </message>
    <message>
        <source>Exact hit</source>
        <translation>精确交点</translation>
    </message>
    <message>
        <source>Formula − hit</source>
        <translation>公式 − 交点</translation>
    </message>
    <message>
        <source>Formula minus exact hit</source>
        <translation>公式减精确交点</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ComparisonPanel</name>
    <message>
        <source>Widget position</source>
        <translation>控件位置</translation>
    </message>
    <message>
        <source>Logical pixels from the view&apos;s top-left corner, y down</source>
        <translation>逻辑像素，原点在视图左上角，y 向下</translation>
    </message>
    <message>
        <source>Device pixel</source>
        <translation>设备像素</translation>
    </message>
    <message>
        <source>Column and row from the top-left corner of the framebuffer, in device pixels</source>
        <translation>帧缓冲中从左上角算起的列和行，以设备像素计</translation>
    </message>
    <message>
        <source>Window position</source>
        <translation>窗口位置</translation>
    </message>
    <message>
        <source>The pixel&apos;s centre in device pixels from the bottom-left corner, y up</source>
        <translation>像素中心，设备像素，原点在左下角，y 向上</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Coordinates by both methods</source>
        <translation>两种方法求出的坐标</translation>
    </message>
    <message>
        <source>Formula with its numbers</source>
        <translation>代入数值的公式</translation>
    </message>
    <message>
        <source>The formula with its numbers:</source>
        <translation>代入数值的公式：</translation>
    </message>
    <message>
        <source>Background: no surface here</source>
        <translation>背景：此处没有表面</translation>
    </message>
    <message>
        <source>%1 logical pixels</source>
        <translation>%1 逻辑像素</translation>
    </message>
    <message>
        <source>(%1, %2) of %3 × %4, ratio %5</source>
        <translation>(%1, %2)，共 %3 × %4，比例 %5</translation>
    </message>
    <message>
        <source>%1, the pixel&apos;s centre</source>
        <translation>%1，像素中心</translation>
    </message>
    <message>
        <source>%1, as read</source>
        <translation>%1，读出的值</translation>
    </message>
    <message>
        <source>%1, the far plane: no surface</source>
        <translation>%1，远平面的值：没有可读的深度</translation>
    </message>
    <message>
        <source>Since the click</source>
        <translation>点击之后</translation>
    </message>
    <message>
        <source>From the depth buffer, in the depth range: by default 0 is the near plane, 1 the far plane</source>
        <translation>来自深度缓冲，在深度范围内：默认 0 为近平面，1 为远平面</translation>
    </message>
    <message>
        <source>Click the same pixel again in the current view</source>
        <translation>拾取这次点击的像素下现在的内容</translation>
    </message>
    <message>
        <source>What the ray through the pixel&apos;s centre meets on the mesh itself, in double</source>
        <translation>经过像素中心的射线与网格本身的交点，双精度</translation>
    </message>
    <message>
        <source>Triangle, vertex and edge</source>
        <translation>三角形、顶点和边</translation>
    </message>
    <message>
        <source>Indices in the model; triangles and vertices are counted from 0</source>
        <translation>以其在模型中的编号表示：三角形和顶点从 0 数起</translation>
    </message>
    <message>
        <source>the surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>公式</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>矩阵</translation>
    </message>
    <message>
        <source>Click the model. Its world coordinate appears here, computed in two ways: by the formulas and by the inverted matrix.</source>
        <translation>点击模型。其世界坐标显示在这里，以两种方式计算：用公式，以及用逆矩阵。</translation>
    </message>
    <message>
        <source>Pick a&amp;gain</source>
        <translation>重新拾取(&amp;G)</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空间</translation>
    </message>
    <message>
        <source>World</source>
        <translation>世界</translation>
    </message>
    <message>
        <source>The coordinate in world space</source>
        <translation>世界空间中的坐标</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>视点</translation>
    </message>
    <message>
        <source>The coordinate in eye space: the eye is the origin, and it looks along −z</source>
        <translation>眼空间中的坐标：视点为原点，朝 −z 方向看</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>The coordinate in the space of the clicked object</source>
        <translation>被点击物体空间中的坐标</translation>
    </message>
    <message>
        <source>Floa&amp;t</source>
        <translation>单精度(&amp;T)</translation>
    </message>
    <message>
        <source>Add the matrix inverse in single precision, as most programs compute it</source>
        <translation>加上单精度的矩阵求逆，多数程序如此计算</translation>
    </message>
    <message>
        <source>Add the point where the ray through the pixel&apos;s centre meets the mesh itself</source>
        <translation>加上过像素中心的射线与网格本身的交点</translation>
    </message>
    <message>
        <source>From the pixel to the window point</source>
        <translation>从像素到窗口点</translation>
    </message>
    <message>
        <source>Steps from the mouse position to window coordinates</source>
        <translation>点击从鼠标到窗口坐标的过程</translation>
    </message>
    <message>
        <source>Exact hit on the mesh</source>
        <translation>网格上的精确交点</translation>
    </message>
    <message>
        <source>What the ray through the pixel&apos;s centre meets on the mesh itself, without the depth buffer</source>
        <translation>过像素中心的射线在网格本身上的交点，不用深度缓冲</translation>
    </message>
    <message>
        <source>Answers of other programs</source>
        <translation>其他程序会给出什么</translation>
    </message>
    <message>
        <source>Distance of their points from the formula&apos;s for the same click, with the reason</source>
        <translation>对同一次点击：它们的点与公式的点相距多远，以及原因</translation>
    </message>
    <message>
        <source>In other APIs</source>
        <translation>其他 API 中的表示</translation>
    </message>
    <message>
        <source>The same click in the conventions of Vulkan, Direct3D, Unity, OpenCV and others</source>
        <translation>同一次点击在 Vulkan、Direct3D、Unity、OpenCV 等中的坐标</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1：</translation>
    </message>
    <message>
        <source>The hit, its normal and the nearest vertex</source>
        <translation>交点、其法线与最近的顶点</translation>
    </message>
    <message>
        <source>The pixel of this click is outside the view now.</source>
        <translation>这次点击的像素现在在视图之外。</translation>
    </message>
    <message>
        <source>Earlier picks</source>
        <translation>先前的拾取</translation>
    </message>
    <message>
        <source>The last picks of this scene. Show one again, or compare two</source>
        <translation>此场景最近的拾取：可再次显示，也可比较其中两次</translation>
    </message>
    <message>
        <source>Values at the click and now</source>
        <translation>点击时与现在的数值</translation>
    </message>
    <message>
        <source>The picked point in the view as it was at the click and as it is now, and what differs</source>
        <translation>拾取的点在点击时的视图和现在的视图中的坐标，以及有何不同</translation>
    </message>
    <message>
        <source>Eye</source>
        <comment>space</comment>
        <translation>观察</translation>
    </message>
    <message>
        <source>E&amp;xact hit</source>
        <translation>精确交点(&amp;X)</translation>
    </message>
    <message>
        <source>Exact hit</source>
        <translation>精确交点</translation>
    </message>
    <message>
        <source>Edge in the pixel</source>
        <translation>像素内的边缘</translation>
    </message>
    <message>
        <source>Rays of this pixel hit surfaces at different distances. Zoom in to choose one of them.</source>
        <translation>这个像素的各条射线在不同距离处与表面相交。放大可选择其中之一。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ComputingButton</name>
    <message>
        <source>Cancel the computation of curves on the surface</source>
        <translation>取消计算表面上的曲线</translation>
    </message>
    <message>
        <source>Cancel, %1 %</source>
        <translation>取消，%1 %</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::CoordinatesTable</name>
    <message>
        <source>Near</source>
        <translation>近</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::CornersModel</name>
    <message>
        <source>Beyond [-1, 1]: outside the viewport, nothing is drawn there</source>
        <translation>超出 [-1, 1]：在视口之外，那里不绘制任何内容</translation>
    </message>
    <message>
        <source>Widget</source>
        <translation>控件</translation>
    </message>
    <message>
        <source>Device pixel</source>
        <translation>设备像素</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>Top left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>左下</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Pointer</source>
        <translation>指针</translation>
    </message>
    <message>
        <source>Logical pixels from the top-left corner, y down; mouse events report this position</source>
        <translation>逻辑像素，原点在左上角，y 向下：在该像素上点击时报告的位置</translation>
    </message>
    <message>
        <source>Column and row in device pixels from the top-left corner: widget × device pixel ratio</source>
        <translation>从左上角算起的列和行，设备像素：控件坐标 × 设备像素比</translation>
    </message>
    <message>
        <source>The pixel&apos;s centre in device pixels from the bottom-left corner, y up</source>
        <translation>像素中心，设备像素，原点在左下角，y 向上</translation>
    </message>
    <message>
        <source>The pixel&apos;s centre, −1 to 1 across the viewport, y up; no unit</source>
        <translation>像素中心，在视口内从 −1 到 1，y 向上；无单位</translation>
    </message>
    <message>
        <source>The pixel of the window under the pointer</source>
        <translation>指针下方的窗口像素</translation>
    </message>
    <message>
        <source>The pixel right below the window&apos;s centre: half its width and half its height</source>
        <translation>窗口中心右下方的像素：宽和高的一半</translation>
    </message>
    <message>
        <source>The pixel in this corner of the window, not of the viewport</source>
        <translation>位于窗口（不是视口）这个角上的像素</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::CurvatureBar</name>
    <message>
        <source>Computing the curvature</source>
        <translation>正在计算曲率</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Show the surface without its curvature</source>
        <translation>显示没有曲率的表面</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::CurveWaiting</name>
    <message>
        <source>Computing curves on the surface…</source>
        <translation>正在曲面上计算曲线……</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Computing curves on the surface: %1 of %2</source>
        <translation>正在曲面上计算曲线：%1 / %2</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::CurvesView</name>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>标志点</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Semilandmarks at equal steps along the curve, both ends included; exported with the landmarks</source>
        <translation>半标志点，沿曲线等距分布，包括两端；与点一起写入文件</translation>
    </message>
    <message>
        <source>Reason for the missing curve</source>
        <translation>为何没有曲线</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>No curve: %1.</source>
        <translation>没有曲线：%1。</translation>
    </message>
    <message>
        <source>On the &amp;Surface</source>
        <translation>沿曲面(&amp;S)</translation>
    </message>
    <message>
        <source>Geodesic: like a thread pulled tight on the surface</source>
        <translation>测地线：如同在曲面上拉紧的线</translation>
    </message>
    <message>
        <source>Along a &amp;Plane</source>
        <translation>沿平面(&amp;P)</translation>
    </message>
    <message>
        <source>Section of the surface with the plane through two landmarks and the surface&apos;s normals there</source>
        <translation>过两标志点及其处曲面法线的平面与曲面的交线</translation>
    </message>
    <message>
        <source>as read</source>
        <translation>如文件所给</translation>
    </message>
    <message>
        <source>geodesic</source>
        <translation>测地线</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Follow a &amp;Plane</source>
        <translation>改为沿平面(&amp;P)</translation>
    </message>
    <message>
        <source>Follow the &amp;Surface</source>
        <translation>改为沿曲面(&amp;S)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>移除(&amp;M)</translation>
    </message>
    <message>
        <source>“%1” cannot be the name: it is empty, or another curve has it.</source>
        <translation>“%1”不能作为它的名称：名称为空，或已是另一条曲线的名称。</translation>
    </message>
    <message>
        <source>n is “%1”; a curve has 2 to %2 semilandmarks.</source>
        <translation>n 为“%1”；一条曲线有 2 到 %2 个半标志点。</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <comment>a curve, its points, its length</comment>
        <translation>%1 %2：%3</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Join the selected landmarks on the surface, in the order of their selection, to a curve with semilandmarks</source>
        <translation>按选择的次序在表面上连接选中的标志点，得到带半标志点的曲线</translation>
    </message>
    <message>
        <source>&amp;Compute Again</source>
        <translation>重新计算(&amp;C)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::DepthPrecisionPanel</name>
    <message>
        <source>32-bit floats</source>
        <translation>32 位浮点</translation>
    </message>
    <message>
        <source>%1 bits</source>
        <translation>%1 位</translation>
    </message>
    <message>
        <source>In the middle of the view, %1 in front of the eye, a rounded depth is accurate to ±%2.</source>
        <translation>在画面中部、视点前方 %1 处，深度的舍入留下 ±%2 的不确定。</translation>
    </message>
    <message>
        <source>Near %1 instead of %2 makes this %3 times better here (±%4).</source>
        <translation>把近平面从 %2 改为 %1，这里的精度提高到 %3 倍（±%4）。</translation>
    </message>
    <message>
        <source>A float buffer with NDC depths from 0 to 1 (glClipControl) and reversed depths (1 at near) would be %1 times better (±%2).</source>
        <translation>改用浮点深度缓冲、NDC 深度取 0 到 1（glClipControl）、并让投影在近平面处为 1，精度可提高到 %1 倍（±%2）。</translation>
    </message>
    <message>
        <source>as drawn: %1</source>
        <translation>当前：%1</translation>
    </message>
    <message>
        <source>At the point, %1 in front of the eye, a rounded depth is accurate to ±%2.</source>
        <translation>在所选点处（视点前方 %1），深度的舍入留下 ±%2 的不确定。</translation>
    </message>
    <message>
        <source>with near %1</source>
        <translation>近平面为 %1 时</translation>
    </message>
    <message>
        <source>Near is about as large as the objects allow.</source>
        <translation>近平面已大致是物体所允许的最远处。</translation>
    </message>
    <message>
        <source>floats, reversed</source>
        <translation>浮点，反向</translation>
    </message>
    <message>
        <source>With glOrtho the error is the same at every distance. Only a shorter range from near to far reduces it.</source>
        <translation>在 glOrtho 这样的长方体中，任何距离都是如此；只有缩短近、远平面之间的距离才能减小它。</translation>
    </message>
    <message>
        <source>24 bits are assumed until the first click reads the depth buffer.</source>
        <translation>假定深度缓冲为 24 位：第一次点击后才知道实际位数。</translation>
    </message>
    <message>
        <source>as drawn: %1, assumed</source>
        <translation>按所绘：%1（假定）</translation>
    </message>
    <message>
        <source>A float buffer with reversed depths (1 at near) would change little here (±%1).</source>
        <translation>用近处为 1 的浮点深度缓冲，在这里几乎没有差别（±%1）。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::DepthPrecisionPlot</name>
    <message>
        <source>Error of a rounded depth over the distance</source>
        <translation>深度舍入留下的不确定随距离的变化</translation>
    </message>
    <message>
        <source>distance in front of the eye, scene units</source>
        <translation>视点前方的距离（场景单位）</translation>
    </message>
    <message>
        <source>± along the view, scene units</source>
        <translation>沿视线方向的 ±（场景单位）</translation>
    </message>
    <message>
        <source>Across: the distance in front of the eye, from the near to the far plane.
Up: the error that rounding the depth causes along the view, ±.
Both in the scene&apos;s units. The circle is the clicked point. A click&apos;s ± also contains the errors of drawing.</source>
        <translation>横轴：到视点的距离，从近平面到远平面。
纵轴：沿视线方向，表面与舍入后的深度所示位置可能相差多少（±）。
均以场景单位计。圆圈是点击的点。绘制本身的偏差另计在点击的 ± 中。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::DerivationLine</name>
    <message>
        <source>Computation of the chosen number</source>
        <translation>所选的数是怎样算出来的</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::DeviationsModel</name>
    <message>
        <source>out of place</source>
        <translation>位置不对</translation>
    </message>
    <message>
        <source>left and right are swapped on the whole scan</source>
        <translation>整个扫描左右对调</translation>
    </message>
    <message>
        <source>left and right are swapped</source>
        <translation>左右对调</translation>
    </message>
    <message>
        <source>swapped with %1</source>
        <translation>与 %1 对调</translation>
    </message>
    <message>
        <source>Distance from where the other scans put it, in units of the scan</source>
        <translation>离其他扫描给出的位置的距离，以扫描的单位计</translation>
    </message>
    <message>
        <source>The same, divided by the usual distance of this landmark on the other scans</source>
        <translation>同一距离，除以该标志点在其他扫描上的通常距离</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>标志点</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Spreads</source>
        <translation>散布倍数</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::DeviationsView</name>
    <message>
        <source>Landmarks by their distance from where the other scans put them</source>
        <translation>标志点，按离其他扫描给出的位置的距离排列</translation>
    </message>
    <message>
        <source>The scans could not be compared: %1.</source>
        <translation>无法比较各扫描：%1。</translation>
    </message>
    <message>
        <source>The comparison needs at least %1 scans with the same %2 landmarks.</source>
        <translation>比较至少需要 %1 个扫描，且有同样的 %2 个标志点。</translation>
    </message>
    <message>
        <source>Compared scans: %1. Landmarks more than %2 spreads off: %3.</source>
        <translation>已比较的扫描：%1。偏离超过 %2 倍散布的标志点：%3。</translation>
    </message>
    <message>
        <source>Left and right seem to be swapped on %1; %2 scans cannot tell for which pairs. Look there.</source>
        <translation>%1 上的左右似乎对调了；%2 个扫描无法判断是哪几对。请查看该扫描。</translation>
    </message>
    <message>
        <source>Not compared, with fewer than %1 landmarks that others have: %2.</source>
        <translation>未比较，其他扫描也有的标志点少于 %1 个：%2。</translation>
    </message>
    <message>
        <source>On fewer than %1 scans: %2.</source>
        <translation>所在扫描少于 %1 个：%2。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::DiagnosisView</name>
    <message>
        <source>Verdict</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>依据</translation>
    </message>
    <message>
        <source>Pick that pixel and type your program&apos;s result there; it separates the first mistake from the others</source>
        <translation>拾取那个像素，再键入您的程序在那里得到的坐标：由此可以区分第一个候选与其余候选</translation>
    </message>
    <message>
        <source>Explains</source>
        <translation>能解释</translation>
    </message>
    <message>
        <source>Closest</source>
        <translation>最接近</translation>
    </message>
    <message>
        <source>As well</source>
        <translation>同样能解释</translation>
    </message>
    <message>
        <source>Is also</source>
        <translation>同时也是</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>runner-up: its answer, how many digits it explains</comment>
        <translation>%1：%2，%3</translation>
    </message>
    <message>
        <source>Chance</source>
        <translation>巧合</translation>
    </message>
    <message>
        <source>Right is</source>
        <translation>正确的点</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>from the mesh under the pixel</source>
        <translation>像素下的网格的深度</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>位数</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a mistake: how many digits it explains</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Next best</source>
        <translation>其次</translation>
    </message>
    <message>
        <source>To be sure</source>
        <translation>要确认</translation>
    </message>
    <message>
        <source>Projects</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Click &amp;there to tell them apart: %1</source>
        <translation>点击那里以区分(&amp;T)：%1</translation>
    </message>
    <message>
        <source>Click &amp;there to be sure: %1</source>
        <translation>点击那里以确认(&amp;T)：%1</translation>
    </message>
    <message>
        <source>Click &amp;there to rule out the next best: %1</source>
        <translation>点击那里以排除次优解释(&amp;T)：%1</translation>
    </message>
    <message>
        <source>Pick that pixel and type your program&apos;s result there; it separates the named mistakes from the next best</source>
        <translation>拾取该像素并输入您的程序在那里的结果；它把所列的、彼此无法区分的错误与次优解释分开</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::DoctorFeature</name>
    <message>
        <source>Doctor</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Find the mistake that gives your program a wrong coordinate</source>
        <translation>找出您的程序因哪个错误得到了错误的坐标</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::DoctorPanel</name>
    <message>
        <source>&amp;In the space:</source>
        <translation>所在空间(&amp;I)：</translation>
    </message>
    <message>
        <source>The mistakes could not be tried: %1. Close other programs, then try again.</source>
        <translation>无法试遍所有错误：%1。请关闭其他程序，然后重试。</translation>
    </message>
    <message>
        <source>Click the pixel that you gave to your program, and type the wrong coordinate that it returned.</source>
        <translation>在视图里点击您的程序所处理的那个像素，再键入它得到的错误坐标。</translation>
    </message>
    <message>
        <source>Enter the pixel and the three coordinates that your program returned for it.</source>
        <translation>请给出像素，以及您的程序为它得到的三个坐标。</translation>
    </message>
    <message>
        <source>The object of this space is not in the scene. Choose the space of your program&apos;s coordinates.</source>
        <translation>这个空间所属的物体不在场景中。请选择您的程序给出的坐标所在的空间。</translation>
    </message>
    <message>
        <source>a click on the background has no pixel in another setup.</source>
        <translation>背景上的点击在另一个设置中没有像素。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::DoctorText</name>
    <message>
        <source>Or: %1 %2</source>
        <comment>another mistake that explains the point; why they are not told apart</comment>
        <translation>或者：%1%2</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::EarlierPicksView</name>
    <message>
        <source>Picks of this scene</source>
        <translation>此场景的拾取</translation>
    </message>
    <message>
        <source>Click a row to show that pick again. Ctrl + click a second row to compare the two</source>
        <translation>点击一行以再次显示该拾取。按住 Ctrl 点击另一行以比较两者</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>World coordinate</source>
        <translation>世界坐标</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>To the last certain digit; world units</source>
        <translation>到最后一位可靠数字；世界单位</translation>
    </message>
    <message>
        <source>Column and row from the top-left corner of the framebuffer, in device pixels</source>
        <translation>帧缓冲中从左上角算起的列和行，以设备像素计</translation>
    </message>
    <message>
        <source>Differences of two picks</source>
        <translation>两次拾取的差别</translation>
    </message>
    <message>
        <source>Copy as &amp;text</source>
        <translation>复制为文本(&amp;T)</translation>
    </message>
    <message>
        <source>Copy as &amp;CSV</source>
        <translation>复制为 CSV(&amp;C)</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>全部复制</translation>
    </message>
    <message>
        <source>Copy all picks: as text as they are shown, as CSV with all digits</source>
        <translation>复制所有拾取：文本与显示相同，CSV 含全部数位</translation>
    </message>
    <message>
        <source>This pick is shown above</source>
        <translation>上方显示的是这次拾取</translation>
    </message>
    <message>
        <source>Pick %1</source>
        <translation>拾取 %1</translation>
    </message>
    <message>
        <source>Select two rows to compare them (Ctrl + click, or Shift with the arrow keys).</source>
        <translation>选择两行以比较（按住 Ctrl 点击，或按住 Shift 用方向键）。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::EntryDerivation</name>
    <message>
        <source>%1; the number shown, %2, is the input, and the steps before it were computed back from it</source>
        <translation>%1；显示的数 %2 是给定的，通向它的数是由它反算得到的</translation>
    </message>
    <message>
        <source>row %1 of %2 · %3</source>
        <translation>%2 的第 %1 行 · %3</translation>
    </message>
    <message>
        <source>%3 · column %1 of %2</source>
        <translation>%3 · %2 的第 %1 列</translation>
    </message>
    <message>
        <source>%1 = 1, as for every point</source>
        <translation>%1 = 1，每个点都如此</translation>
    </message>
    <message>
        <source>%1 is the depth that was read at the click</source>
        <translation>%1 是点击时读取的深度</translation>
    </message>
    <message>
        <source>%1 was computed: a widget position has no depth</source>
        <translation>%1 是算出来的：控件位置没有深度</translation>
    </message>
    <message>
        <source>0: the %1 shown is only rounding error</source>
        <translation>0：显示的 %1 不超过舍入的残余</translation>
    </message>
    <message>
        <source>%1: start of the forward path; switch to Backward to see it computed from world.</source>
        <translation>%1：正向路径的起点；切换到“逆向”可看它如何由世界坐标算出。</translation>
    </message>
    <message>
        <source>%1: start of the backward path; switch to Forward to see it computed from window.</source>
        <translation>%1：逆向路径的起点；切换到“正向”可看它如何由窗口坐标算出。</translation>
    </message>
    <message>
        <source>%1 has no number yet: click the model, or type a point.</source>
        <translation>%1 还没有数：请点击模型，或输入一个点。</translation>
    </message>
    <message>
        <source>Click a number to see how it is computed. Double-click a vector to type your own.</source>
        <translation>点击一个数，可看它是怎样算出来的。双击向量，可输入您自己的数。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ExpectedLandmarks</name>
    <message>
        <source>Expected places come from the other scans of a series. No scan of a series is shown.</source>
        <translation>预期位置来自系列的其他扫描。现在没有显示系列的扫描。</translation>
    </message>
    <message>
        <source>No landmark is next, so there is no expected place. Choose a landmark that is not placed.</source>
        <translation>没有下一个标志点，因此没有预期位置。请选择一个尚未放置的标志点。</translation>
    </message>
    <message>
        <source>No other scan of the series has landmarks that tell where the next one is.</source>
        <translation>系列的其他扫描都没有能说明下一个标志点在哪里的标志点。</translation>
    </message>
    <message>
        <source>Place three landmarks that other scans have. Then the other scans tell where the next one is.</source>
        <translation>请放置三个其他扫描也有的标志点。然后其他扫描会说明下一个在哪里。</translation>
    </message>
    <message>
        <source>The placed landmarks are on a line. Place one beside it: then the other scans tell where the next one is.</source>
        <translation>已放置的标志点在一条直线上。请在直线旁边放置一个：然后其他扫描会说明下一个在哪里。</translation>
    </message>
    <message>
        <source>No other scan of the series has %1.</source>
        <translation>系列的其他扫描都没有 %1。</translation>
    </message>
    <message>
        <source>No other scan has landmarks of this placing (%1) that tell where the next one is.</source>
        <translation>没有其他扫描含有本遍次（%1）的标志点来说明下一个在哪里。</translation>
    </message>
    <message>
        <source>No other scan has %1 in this placing (%2).</source>
        <translation>没有其他扫描在本遍次（%2）中含有 %1。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ExpectedMark</name>
    <message>
        <source>%1 expected here</source>
        <comment>a landmark</comment>
        <translation>%1 预期在此</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ExportPictureDialog</name>
    <message>
        <source>Export Image</source>
        <translation>导出图像</translation>
    </message>
    <message>
        <source>Reason why the image cannot be exported</source>
        <translation>为何无法导出这样的图像</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Choose a file and write the image</source>
        <translation>选择文件并写入图像</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Width of the image in pixels</source>
        <translation>图像的宽度，像素</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Height of the image in pixels</source>
        <translation>图像的高度，像素</translation>
    </message>
    <message>
        <source>Pixel ratio</source>
        <translation>像素比</translation>
    </message>
    <message>
        <source>Image pixels per logical pixel; sets the size of lines, markers and letters</source>
        <translation>一个逻辑像素对应的图像像素：决定线条、标记和文字的大小</translation>
    </message>
    <message>
        <source>&amp;Keep the view&apos;s proportions</source>
        <translation>保持视图的比例(&amp;K)</translation>
    </message>
    <message>
        <source>Width, height and pixel ratio change together: the same image at another size</source>
        <translation>宽度、高度和像素比一同改变：同样的图像，只是大小不同</translation>
    </message>
    <message>
        <source>&amp;Width:</source>
        <translation>宽度(&amp;W)：</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>高度(&amp;H)：</translation>
    </message>
    <message>
        <source>Pixel &amp;ratio:</source>
        <translation>像素比(&amp;R)：</translation>
    </message>
    <message>
        <source>Also shown</source>
        <translation>除物体外还显示</translation>
    </message>
    <message>
        <source>&amp;Pick</source>
        <translation>拾取(&amp;P)</translation>
    </message>
    <message>
        <source>The picked point with its lines to the ground</source>
        <translation>所拾取的点及其到地面的线</translation>
    </message>
    <message>
        <source>&amp;Landmarks</source>
        <translation>标志点(&amp;L)</translation>
    </message>
    <message>
        <source>The placed landmarks with their names</source>
        <translation>已放置的标志点及其名称</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>曲线(&amp;C)</translation>
    </message>
    <message>
        <source>The curves between landmarks</source>
        <translation>标志点之间的曲线</translation>
    </message>
    <message>
        <source>&amp;Ground and clip planes</source>
        <translation>地面和裁剪平面(&amp;G)</translation>
    </message>
    <message>
        <source>The grid on the ground, and the planes that cut the objects</source>
        <translation>地面上的网格，以及切割物体的平面</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>坐标轴(&amp;A)</translation>
    </message>
    <message>
        <source>The axes of the world, and their directions in the corner</source>
        <translation>世界坐标轴，以及角落里它们的方向</translation>
    </message>
    <message>
        <source>The map&apos;s colours over the objects; needs the proportions of the view</source>
        <translation>物体上方映射图的颜色；仅在保持视图比例时</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>透明背景(&amp;T)</translation>
    </message>
    <message>
        <source>Leave the background of the image transparent</source>
        <translation>让图像的背景透明</translation>
    </message>
    <message>
        <source>OpenGL has not started, so no image can be exported.</source>
        <translation>OpenGL 尚未启动，没有可导出的图像。</translation>
    </message>
    <message>
        <source>The graphics driver draws at most %1 × %1 pixels. You entered %2 × %3.</source>
        <translation>显卡驱动最多绘制 %1 × %1 像素。您输入的是 %2 × %3。</translation>
    </message>
    <message>
        <source>An image has at most %1 million pixels. You entered %2 × %3, which are %4 million.</source>
        <translation>图像最多 %1 百万像素。您输入的 %2 × %3 是 %4 百万。</translation>
    </message>
    <message>
        <source>OpenGL has no memory for an image of %1 × %2 pixels. Choose a smaller size.</source>
        <translation>OpenGL 没有足够内存绘制 %1 × %2 像素的图像。请选择较小的尺寸。</translation>
    </message>
    <message>
        <source>Image (*.png)</source>
        <translation>图像 (*.png)</translation>
    </message>
    <message>
        <source>Image written to %1</source>
        <translation>图像已写入 %1</translation>
    </message>
    <message>
        <source>Error &amp;map</source>
        <translation>误差图(&amp;M)</translation>
    </message>
    <message>
        <source>The view shows no map. View &gt; Error Map shows one.</source>
        <translation>视图未显示误差图。“视图 &gt; 误差图”可显示。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FactorDrawing</name>
    <message>
        <source>The view volume and the cube from −1 to 1</source>
        <translation>视景体与从 −1 到 1 的立方体</translation>
    </message>
    <message>
        <source>Solid: the view volume after the factors, its near side blue, its far side orange.
Dashed: the cube from −1 to 1 with its axes, the result of the whole product.
Both are scaled to fit.</source>
        <translation>实线：经过各因子之后的视景体，近侧为蓝色，远侧为橙色。
虚线：从 −1 到 1 的立方体及其坐标轴，完整的乘积把视景体变成它。
两者都按能容纳的大小绘制。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FactorShares</name>
    <message>
        <source>the oblique projection</source>
        <translation>斜投影</translation>
    </message>
    <message>
        <source>None</source>
        <translation>全不用</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Set every factor to 0 %: the view volume stays unchanged</source>
        <translation>把每个因子设为 0 %：视景体保持原样</translation>
    </message>
    <message>
        <source>Set every factor to 100 %: the whole matrix</source>
        <translation>把每个因子设为 100 %：完整的矩阵</translation>
    </message>
    <message>
        <source>None of the factors</source>
        <translation>所有因子都不用</translation>
    </message>
    <message>
        <source>All of the factors</source>
        <translation>使用所有因子</translation>
    </message>
    <message>
        <source>Product of the active factors</source>
        <translation>起作用的部分的乘积</translation>
    </message>
    <message>
        <source>Comparison with the projection matrix</source>
        <translation>它是否为投影矩阵</translation>
    </message>
    <message>
        <source>Bounds of the view volume</source>
        <translation>视景体所在的范围</translation>
    </message>
    <message>
        <source>Their product:</source>
        <translation>它们的乘积：</translation>
    </message>
    <message>
        <source>This is the matrix of %1, to the last digit.</source>
        <translation>这就是 %1 的矩阵，每一位都相同。</translation>
    </message>
    <message>
        <source>This is the matrix of %1, to within %2 ulp (units in the last place).</source>
        <translation>这就是 %1 的矩阵，相差不超过 %2 ulp（末位单位）。</translation>
    </message>
    <message>
        <source>At 100 % of each it is the matrix of %1.</source>
        <translation>每个都为 100 % 时，它就是 %1 的矩阵。</translation>
    </message>
    <message>
        <source>The view volume reaches from %1 to %2 in x, from %3 to %4 in y, from %5 to %6 in z.</source>
        <translation>视景体的范围：x 从 %1 到 %2，y 从 %3 到 %4，z 从 %5 到 %6。</translation>
    </message>
    <message>
        <source>Strength of each factor:</source>
        <translation>每个因子的强度：</translation>
    </message>
    <message>
        <source>Strength of %1, percent</source>
        <translation>%1 的强度，百分比</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FactorsView</name>
    <message>
        <source>moves the eye to the origin</source>
        <translation>把视点移到原点</translation>
    </message>
    <message>
        <source>turns the world: the eye&apos;s axes, right, up and backward (s, u, −f), become x, y and z</source>
        <translation>旋转世界：观察坐标系的轴，向右、向上、向后（s、u、−f），成为 x、y、z 轴</translation>
    </message>
    <message>
        <source>shears: x and y go along with z, by cot θ and cot φ</source>
        <translation>错切：x 和 y 随 z 移动，系数为 cot θ 和 cot φ</translation>
    </message>
    <message>
        <source>shears: x goes along with y, by the skew</source>
        <translation>错切：x 随 y 移动，系数为倾斜</translation>
    </message>
    <message>
        <source>moves the box&apos;s middle to the origin</source>
        <translation>把长方体的中心移到原点</translation>
    </message>
    <message>
        <source>scales the box&apos;s sides to 2</source>
        <translation>把长方体的各边缩放为 2</translation>
    </message>
    <message>
        <source>flips z: greater is then farther away</source>
        <translation>反转 z：此后越大越远</translation>
    </message>
    <message>
        <source>projects onto the near plane, once w = −z divides: n·x, n·y, and a·z + b for the depth</source>
        <translation>除以 w = −z 之后即投影到近平面：n·x、n·y，深度为 a·z + b</translation>
    </message>
    <message>
        <source>takes the near plane&apos;s window to −1 to 1 across and up</source>
        <translation>把近平面上的窗口变到横向、纵向的 −1 到 1</translation>
    </message>
    <message>
        <source>converts the axes of the chosen conventions to OpenGL&apos;s</source>
        <translation>从所示约定的坐标轴变到 OpenGL 的坐标轴</translation>
    </message>
    <message>
        <source>converts OpenGL&apos;s axes to those of the chosen conventions</source>
        <translation>从 OpenGL 的坐标轴变到所示约定的坐标轴</translation>
    </message>
    <message>
        <source>To change the strength of each factor, choose OpenGL&apos;s conventions: the drawing compares with OpenGL&apos;s cube.</source>
        <translation>要试着让每个因子只作用一部分，请选择 OpenGL 的约定：视景体旁边画的是 OpenGL 的立方体。</translation>
    </message>
    <message>
        <source>The product of the factors</source>
        <translation>各因子的乘积</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>因子</translation>
    </message>
    <message>
        <source>= %1, to the last digit</source>
        <translation>= %1，直到最后一位都相同</translation>
    </message>
    <message>
        <source>= %1, to within %2 ulp (units in the last place)</source>
        <translation>= %1，相差不超过 %2 ulp（末位单位）</translation>
    </message>
    <message>
        <source>The sixteen numbers as given cannot be decomposed; these are the factors of their conversion.</source>
        <translation>给定的矩阵只是十六个数，无从分解；这里分解的是由它转换来的矩阵。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FileQuestions</name>
    <message>
        <source>Landmarks already placed: %1. Landmarks in the file: %2. Replace the placed ones, or append the new ones?</source>
        <translation>已放置的标志点：%1 个。文件中的标志点：%2 个。替换它们，还是把新的标志点放在它们后面？</translation>
    </message>
    <message>
        <source>Template names not placed yet: %1. Replace removes them as well; Append fills those that the file contains.</source>
        <translation>模板中等待放置的名称：%1 个。“替换”也会去掉它们；“追加”会让文件中有的点占据它们的位置。</translation>
    </message>
    <message>
        <source>Import Landmarks</source>
        <translation>导入标志点</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>替换(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Append</source>
        <translation>追加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Move Them onto the Mesh</source>
        <translation>移到网格上(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Leave Them Where They Are</source>
        <translation>留在原处(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Take the Names in Order</source>
        <translation>按顺序取用名称(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Append Them</source>
        <translation>排在其后(&amp;P)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FindBar</name>
    <message>
        <source>Previous match (Shift+F3)</source>
        <translation>上一处（Shift+F3）</translation>
    </message>
    <message>
        <source>Next match (F3)</source>
        <translation>下一处（F3）</translation>
    </message>
    <message>
        <source>Find in the page</source>
        <translation>在页面中查找</translation>
    </message>
    <message>
        <source>Text to find; capitals do not matter</source>
        <translation>词语或其中一部分，不区分大小写</translation>
    </message>
    <message>
        <source>Matches</source>
        <translation>查找结果</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>第 %1 处，共 %2 处</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>没有找到</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>关闭（Esc）</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FirstSteps</name>
    <message>
        <source>First steps</source>
        <translation>入门</translation>
    </message>
    <message>
        <source>Close; Help &gt; First Steps brings it back</source>
        <translation>关闭；“帮助 &gt; 入门”可再次显示</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click&lt;/b&gt; a point of the model. Its world coordinate appears on the right, computed in two ways.</source>
        <translation>&lt;b&gt;单击&lt;/b&gt;模型上的一点。它的世界坐标出现在右侧，用两种方法算出。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drag&lt;/b&gt; the view: it turns about the point under the pointer. The wheel zooms.</source>
        <translation>&lt;b&gt;拖动&lt;/b&gt;视图：它绕指针下的点旋转。滚轮缩放。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Take a lesson&lt;/b&gt; of five minutes: &lt;a href=&apos;lesson&apos;&gt;%1&lt;/a&gt;.</source>
        <translation>&lt;b&gt;上一课&lt;/b&gt;，只需五分钟：&lt;a href=&apos;lesson&apos;&gt;%1&lt;/a&gt;。</translation>
    </message>
    <message>
        <source>Three things to try</source>
        <translation>可以试试的三件事</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>To do</source>
        <translation>待做</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FollowedPointRow</name>
    <message>
        <source>Meaning of the points</source>
        <translation>各点的含义</translation>
    </message>
    <message>
        <source>Remove your point</source>
        <translation>移除您的点</translation>
    </message>
    <message>
        <source>Point to follow</source>
        <translation>跟随哪个点</translation>
    </message>
    <message>
        <source>The click</source>
        <translation>点击的点</translation>
    </message>
    <message>
        <source>Your point</source>
        <translation>您的点</translation>
    </message>
    <message>
        <source>Follow the clicked point again; your point is kept</source>
        <translation>重新跟踪点击的点；您的点仍保留</translation>
    </message>
    <message>
        <source>Follow the point that you typed</source>
        <translation>跟踪您用数值给出的点</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FormulaView</name>
    <message>
        <source>Copy the formulas</source>
        <translation>复制公式</translation>
    </message>
    <message>
        <source>This formula in Help</source>
        <translation>帮助中的这个公式</translation>
    </message>
    <message>
        <source>Formula %1 in Help</source>
        <translation>帮助中的公式 %1</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FormulasWindow</name>
    <message>
        <source>Formulas</source>
        <translation>公式</translation>
    </message>
    <message>
        <source>formulas.html</source>
        <extracomment>The file of the page in this language, in resources/help.</extracomment>
        <translation>formulas_zh_CN.html</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Back to the contents</source>
        <translation>返回目录</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::FrameView</name>
    <message>
        <source>OpenGL cannot draw %1 × %2 pixels. Make the window smaller, or update the graphics driver.</source>
        <translation>OpenGL 无法绘制 %1 × %2 像素的画面。请缩小窗口，或更新显卡驱动。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::GpuModel</name>
    <message>
        <source>The graphics memory is too small for %1: parts of it are not drawn. Close other programs, or open a smaller model.</source>
        <translation>显存容纳不下 %1，它没有被完整绘制。请关闭其他程序，或打开较小的模型。</translation>
    </message>
    <message>
        <source>The image %1 is larger than OpenGL allows here; it is shown scaled down to a width of %2 pixels.</source>
        <translation>图像 %1 超出了此处 OpenGL 能绘制的大小，已缩小到 %2 像素宽显示。</translation>
    </message>
    <message>
        <source>The graphics memory is too small for the curvature of %1.</source>
        <translation>显存不足，无法显示 %1 的曲率。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::GroupHeading</name>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>重置%1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>展开</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>已折叠</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::GuidedPlacing</name>
    <message numerus="yes">
        <source>All %n landmarks are placed.</source>
        <translation>
            <numerusform>全部 %n 个标志点已放置。</numerusform>
        </translation>
    </message>
    <message>
        <source>Placed: %1 of %2 landmarks. Missing on this specimen: %3.</source>
        <translation>已放置的标志点：%1 / %2。此标本上缺失：%3。</translation>
    </message>
    <message>
        <source>Next: %1.</source>
        <translation>下一个：%1。</translation>
    </message>
    <message>
        <source>No landmark waits for its position, so there is none to skip.</source>
        <translation>没有等待放置的标志点，因此无可跳过。</translation>
    </message>
    <message>
        <source>%1 is the only landmark that is not placed.</source>
        <translation>只剩 %1 尚未放置。</translation>
    </message>
    <message>
        <source>%1 stays marked as missing.</source>
        <translation>%1 仍标为缺失。</translation>
    </message>
    <message>
        <source>%1 is skipped. It comes again after the others.</source>
        <translation>已跳过 %1。在其他标志点之后再次轮到它。</translation>
    </message>
    <message>
        <source>Select landmarks first: their markers in the view, or their rows in the Landmarks panel.</source>
        <translation>请先选择标志点：点击视图中的标记，或“标志点”面板中的各行。</translation>
    </message>
    <message>
        <source>%1 is not marked as missing any more.</source>
        <translation>%1 不再标为缺失。</translation>
    </message>
    <message numerus="yes">
        <source>%n landmarks are not marked as missing any more.</source>
        <translation>
            <numerusform>%n 个标志点不再标为缺失。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is marked as missing on this specimen.</source>
        <translation>%1 已标为此标本上缺失。</translation>
    </message>
    <message numerus="yes">
        <source>%n landmarks are marked as missing on this specimen.</source>
        <translation>
            <numerusform>%n 个标志点已标为此标本上缺失。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>unprojector::gui::HelpFigures</name>
    <message>
        <source>near</source>
        <translation>近端</translation>
    </message>
    <message>
        <source>cavalier: 1</source>
        <translation>斜等测：1</translation>
    </message>
    <message>
        <source>cabinet: ½</source>
        <translation>斜二测：½</translation>
    </message>
    <message>
        <source>object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>world</source>
        <translation>世界</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>观察</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>widget</source>
        <translation>控件</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>vectors</source>
        <translation>向量</translation>
    </message>
    <message>
        <source>clipping</source>
        <translation>裁剪变换</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>裁掉</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::HelpLink</name>
    <message>
        <source>Its formulas in Help</source>
        <translation>帮助中的相应公式</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::JobFailure</name>
    <message>
        <source>the system cannot start another thread</source>
        <translation>系统无法再启动线程</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>an unexpected error occurred (%1)</source>
        <translation>发生意外错误（%1）</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::KeySheet</name>
    <message>
        <source>Mouse and Keys</source>
        <translation>鼠标与按键</translation>
    </message>
    <message>
        <source>Mouse in the view</source>
        <translation>视图中的鼠标</translation>
    </message>
    <message>
        <source>left button</source>
        <translation>左键</translation>
    </message>
    <message>
        <source>read the world coordinate of the pixel</source>
        <translation>读取该像素的世界坐标</translation>
    </message>
    <message>
        <source>left drag</source>
        <translation>左键拖动</translation>
    </message>
    <message>
        <source>middle drag, or Shift + left drag</source>
        <translation>中键拖动，或 Shift + 左键拖动</translation>
    </message>
    <message>
        <source>move the camera sideways</source>
        <translation>平移相机</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>zoom towards the pointer</source>
        <translation>朝指针缩放</translation>
    </message>
    <message>
        <source>right click, or the menu key</source>
        <translation>右键单击，或菜单键</translation>
    </message>
    <message>
        <source>menu for the pixel and its object</source>
        <translation>可对该像素及其物体执行的操作</translation>
    </message>
    <message>
        <source>Keys in the list of objects</source>
        <translation>物体列表中的按键</translation>
    </message>
    <message>
        <source>Space, Enter, Del</source>
        <translation>空格、回车、Del</translation>
    </message>
    <message>
        <source>show or hide the object, rename it, remove it</source>
        <translation>显示或隐藏、重命名、移除物体</translation>
    </message>
    <message>
        <source>double-click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>bring the point to the middle</source>
        <translation>将该点移到中央</translation>
    </message>
    <message>
        <source>turn the camera about the point under the pointer; the pick is kept</source>
        <translation>绕指针下的点转动相机；之前拾取的点保持不变</translation>
    </message>
    <message>
        <source>Keys in the view</source>
        <translation>视图中的按键</translation>
    </message>
    <message>
        <source>arrows</source>
        <translation>方向键</translation>
    </message>
    <message>
        <source>turn the camera</source>
        <translation>转动相机</translation>
    </message>
    <message>
        <source>Shift + arrows</source>
        <translation>Shift + 方向键</translation>
    </message>
    <message>
        <source>+, −, Page Up, Page Down</source>
        <translation>+、−、Page Up、Page Down</translation>
    </message>
    <message>
        <source>zoom at the crosshair</source>
        <translation>在十字准线处缩放</translation>
    </message>
    <message>
        <source>Ctrl + arrows</source>
        <translation>Ctrl + 方向键</translation>
    </message>
    <message>
        <source>move the crosshair by a pixel, with Shift by ten</source>
        <translation>将十字准线移动一个像素，按住 Shift 移动十个</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>回车</translation>
    </message>
    <message>
        <source>read the world coordinate at the crosshair</source>
        <translation>读取十字准线处的世界坐标</translation>
    </message>
    <message>
        <source>Keys in a field</source>
        <translation>输入框中的按键</translation>
    </message>
    <message>
        <source>Enter, Tab</source>
        <translation>回车、Tab</translation>
    </message>
    <message>
        <source>apply the number or the expression, such as 1/3 or 2*pi</source>
        <translation>应用数值或表达式，例如 1/3 或 2*pi</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>restore the former value</source>
        <translation>恢复原来的值</translation>
    </message>
    <message>
        <source>Up, Down, Page Up, Page Down</source>
        <translation>上、下、Page Up、Page Down</translation>
    </message>
    <message>
        <source>change the digit at the caret by one, by ten</source>
        <translation>将光标处的数位增减一、增减十</translation>
    </message>
    <message>
        <source>Keys in Help</source>
        <translation>帮助中的按键</translation>
    </message>
    <message>
        <source>find words in the page</source>
        <translation>在页面中查找词语</translation>
    </message>
    <message>
        <source>go to the next match, to the previous one</source>
        <translation>转到下一处、上一处</translation>
    </message>
    <message>
        <source>larger text, smaller, in its usual size</source>
        <translation>放大、缩小文字，恢复通常大小</translation>
    </message>
    <message>
        <source>back to the contents</source>
        <translation>回到目录</translation>
    </message>
    <message>
        <source>cancel opening files</source>
        <translation>停止打开正在载入的文件</translation>
    </message>
    <message>
        <source>View from Outside</source>
        <translation>从外部观察</translation>
    </message>
    <message>
        <source>drag of a plane</source>
        <translation>拖动一个平面</translation>
    </message>
    <message>
        <source>move the near or the far plane</source>
        <translation>移动近平面或远平面</translation>
    </message>
    <message>
        <source>left drag, or arrows</source>
        <translation>左键拖动，或方向键</translation>
    </message>
    <message>
        <source>turn about the view volume</source>
        <translation>绕视景体转动</translation>
    </message>
    <message>
        <source>move sideways</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>wheel, or +, −</source>
        <translation>滚轮，或 +、−</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>show everything</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>Keys in a table of numbers</source>
        <translation>数值表中的按键</translation>
    </message>
    <message>
        <source>copy the selected numbers, with all their digits</source>
        <translation>复制所选数值的全部数字</translation>
    </message>
    <message>
        <source>copy a point or a matrix as code</source>
        <translation>把点或矩阵复制为代码</translation>
    </message>
    <message>
        <source>Keys in a group of parameters</source>
        <translation>参数组中的按键</translation>
    </message>
    <message>
        <source>Enter, Left, Right</source>
        <translation>Enter、左、右</translation>
    </message>
    <message>
        <source>fold the group or open it</source>
        <translation>折叠或展开该组</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>上、下</translation>
    </message>
    <message>
        <source>go to the group above, below</source>
        <translation>转到上一组、下一组</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>放置的标志点</translation>
    </message>
    <message>
        <source>left button on a marker</source>
        <translation>在标记上按左键</translation>
    </message>
    <message>
        <source>select the landmark; with Ctrl, add it to the selection</source>
        <translation>选中该标志点；按住 Ctrl 则加选</translation>
    </message>
    <message>
        <source>left drag of a marker</source>
        <translation>左键拖动标记</translation>
    </message>
    <message>
        <source>slide the landmark on the surface; Esc cancels</source>
        <translation>让标志点在表面上滑动；Esc 放回原处</translation>
    </message>
    <message>
        <source>left button, while placing</source>
        <translation>放置点时按左键</translation>
    </message>
    <message>
        <source>arrows, while placing</source>
        <translation>放置点时按方向键</translation>
    </message>
    <message>
        <source>move the selected landmark by a pixel, with Shift by ten, with Alt by a tenth</source>
        <translation>将选中的标志点移动一个像素，按住 Shift 移动十个，按住 Alt 移动十分之一个</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>remove the selected landmarks</source>
        <translation>移除选中的标志点</translation>
    </message>
    <message>
        <source>in the manual, go back to the place before, forward again</source>
        <translation>在手册中回到前一处，再前往后一处</translation>
    </message>
    <message>
        <source>search all pages of the manual</source>
        <translation>搜索手册的所有页面</translation>
    </message>
    <message>
        <source>Ctrl + Shift + left drag</source>
        <translation>Ctrl + Shift + 左键拖动</translation>
    </message>
    <message>
        <source>turn the light from the side; Esc takes the drag back</source>
        <translation>转动侧光；Esc 撤回此次拖动</translation>
    </message>
    <message>
        <source>left drag of an arrow at the selected landmark</source>
        <translation>左键拖动选中标志点处的箭头</translation>
    </message>
    <message>
        <source>move the landmark along the axis, off the surface; A shows the arrows</source>
        <translation>让标志点沿坐标轴移动，离开表面；A 显示箭头</translation>
    </message>
    <message>
        <source>place a landmark; a double-click places one; Esc ends placing</source>
        <translation>放置一个标志点；双击也只放置一个；Esc 结束放置</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarkFiles</name>
    <message>
        <source>Landmarks (%1)</source>
        <translation>标志点 (%1)</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>表格 (%1)</translation>
    </message>
    <message>
        <source>MeshLab, picked points (%1)</source>
        <translation>MeshLab 拾取点 (%1)</translation>
    </message>
    <message>
        <source>3D Slicer, markups (%1)</source>
        <translation>3D Slicer 标记 (%1)</translation>
    </message>
    <message>
        <source>3D Slicer, older markups (%1)</source>
        <translation>3D Slicer 旧式标记 (%1)</translation>
    </message>
    <message>
        <source>IDAV Landmark (%1)</source>
        <translation>IDAV Landmark (%1)</translation>
    </message>
    <message>
        <source>TPS of geomorph and tpsDig (%1)</source>
        <translation>geomorph 与 tpsDig 的 TPS (%1)</translation>
    </message>
    <message>
        <source>NTSYS (%1)</source>
        <translation>NTSYS (%1)</translation>
    </message>
    <message>
        <source>Landmarks far from every object: %1. “%2” is %3 away, %4 % of the object&apos;s size. Do they belong to another object, or use other axes?</source>
        <translation>远离所有物体的标志点：%1 个。“%2”相距 %3，为物体大小的 %4 %。它们是另一个物体的，还是坐标轴不同？</translation>
    </message>
    <message>
        <source>They were moved onto the mesh by at most %1 (%2).</source>
        <translation>它们已移到网格上，最多移动 %1（%2）。</translation>
    </message>
    <message>
        <source>They lie on the mesh.</source>
        <translation>它们就在网格上。</translation>
    </message>
    <message>
        <source>%1 has %2 specimens; the landmarks of the first are shown.</source>
        <translation>%1 有 %2 个标本；显示的是第一个的标志点。</translation>
    </message>
    <message>
        <source>Import landmarks</source>
        <translation>导入标志点</translation>
    </message>
    <message>
        <source>Landmarks read from %1: %2.</source>
        <translation>从 %1 读取的标志点：%2 个。</translation>
    </message>
    <message>
        <source>Landmarks written to %1: %2.</source>
        <translation>写入 %1 的标志点：%2 个。</translation>
    </message>
    <message>
        <source>%1 is in %2, which replaces the scene&apos;s unit, %3. Coordinates are not converted.</source>
        <translation>%1 的单位是 %2：它现在取代 %3 成为场景的单位。没有进行任何换算。</translation>
    </message>
    <message>
        <source>%1 is in %2; the scene has no unit. Coordinates are not converted.</source>
        <translation>%1 的单位是 %2，而场景的单位未知。没有进行任何换算。</translation>
    </message>
    <message>
        <source>%1 is in %2, the scene in %3. Coordinates are not converted.</source>
        <translation>%1 的单位是 %2，而场景的单位是 %3。没有进行任何换算。</translation>
    </message>
    <message>
        <source>%1: the scene keeps its own values of these: %2.</source>
        <translation>%1：场景中以下各项已有别的值，保持不变：%2。</translation>
    </message>
    <message>
        <source>%1: the scene has changed meanwhile. Import the landmarks again.</source>
        <translation>%1：场景在此期间已经改变。请重新导入这些标志点。</translation>
    </message>
    <message>
        <source>No object is under them: open their scan together with them.</source>
        <translation>没有它们所在的物体：请把它们的扫描与它们一起打开。</translation>
    </message>
    <message>
        <source>On the mesh: %1.</source>
        <translation>在网格上：%1 个。</translation>
    </message>
    <message>
        <source>Left free, far from the mesh: %1.</source>
        <translation>远离网格，留在原处不固定：%1 个。</translation>
    </message>
    <message>
        <source>Not placed: %1.</source>
        <translation>没有位置：%1 个。</translation>
    </message>
    <message>
        <source>%1 was not written: %2.</source>
        <translation>%1 未写入：%2。</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 及另外 %2 个</translation>
    </message>
    <message>
        <source>Semilandmarks, not imported as landmarks: %1, of %2.</source>
        <translation>另有半标志点 %1 个，属于 %2；它们不算放置的点。</translation>
    </message>
    <message>
        <source>Names filled: %1.</source>
        <translation>已得到点的名称：%1 个。</translation>
    </message>
    <message>
        <source>%1: names that are not in the template, appended: %2.</source>
        <translation>%1：没有等待放置的名称与之对应、排在其他点之后的：%2。</translation>
    </message>
    <message>
        <source>Still to place: %1.</source>
        <translation>仍未放置：%1。</translation>
    </message>
    <message>
        <source>%1 has landmarks without names: %2. Names to place: %3. Assign these names in order, or append the landmarks without names?</source>
        <translation>%1 没有名称，只有顺序：%2 个标志点。等待放置的名称：%3 个。让这些标志点按顺序取用这些名称（到其中一方用完为止），还是不带名称排在其后？</translation>
    </message>
    <message>
        <source>%1 has no names: its landmarks took the unplaced names in order. Check that the order is right.</source>
        <translation>%1 没有名称：其中的标志点已按顺序取用等待放置的名称。请确认顺序一致。</translation>
    </message>
    <message>
        <source>%1: the scene keeps its own curves: %2.</source>
        <translation>%1：场景中已有这些曲线，保留场景自己的：%2。</translation>
    </message>
    <message>
        <source>%1 has no names: its landmarks took the names of the former ones, in order.</source>
        <translation>%1 没有名称：其中的标志点已按顺序取用原有各标志点的名称。</translation>
    </message>
    <message>
        <source>%1: landmarks without a name, appended: %2.</source>
        <translation>%1：没有名称、排在其他标志点之后的标志点：%2 个。</translation>
    </message>
    <message>
        <source>Missing on this specimen: %1.</source>
        <translation>此标本上缺失：%1。</translation>
    </message>
    <message>
        <source>The sliders of the semilandmarks, for geomorph&apos;s gpagen(curves=), are in %1.</source>
        <translation>半标志点的滑动点表在 %1 中，供 geomorph 的 gpagen(curves=) 使用。</translation>
    </message>
    <message>
        <source>%1 is of an earlier export and does not fit %2. Remove it.</source>
        <translation>%1 来自更早的导出，与 %2 不相符。请删除它。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarkLooksMenu</name>
    <message>
        <source>Landmar&amp;ks</source>
        <translation>标志点(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>名称(&amp;L)</translation>
    </message>
    <message>
        <source>Show the names of the landmarks in the view</source>
        <translation>在视图中显示标志点的名称</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>&amp;Small</source>
        <translation>小(&amp;S)</translation>
    </message>
    <message>
        <source>Small markers, for many landmarks</source>
        <translation>小标记，适合很多标志点</translation>
    </message>
    <message>
        <source>&amp;Medium</source>
        <translation>中(&amp;M)</translation>
    </message>
    <message>
        <source>Markers of medium size</source>
        <translation>中等大小的标记</translation>
    </message>
    <message>
        <source>Lar&amp;ge</source>
        <translation>大(&amp;G)</translation>
    </message>
    <message>
        <source>Large markers, for a large screen</source>
        <translation>大标记，适合大屏幕</translation>
    </message>
    <message>
        <source>Mesh edges in the loupe</source>
        <translation>放大镜中网格的边</translation>
    </message>
    <message>
        <source>&amp;Where They Are Long</source>
        <translation>边较长时(&amp;W)</translation>
    </message>
    <message>
        <source>Show the edges in the loupe only where most are longer than 6 pixels</source>
        <translation>仅当多数边长于 6 个像素时，在放大镜中显示边</translation>
    </message>
    <message>
        <source>&amp;Always</source>
        <translation>始终(&amp;A)</translation>
    </message>
    <message>
        <source>Always show the edges in the loupe</source>
        <translation>始终在放大镜中显示边</translation>
    </message>
    <message>
        <source>&amp;Never</source>
        <translation>从不(&amp;N)</translation>
    </message>
    <message>
        <source>Show only the surface in the loupe</source>
        <translation>在放大镜中只显示表面</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarkMark</name>
    <message>
        <source>%1 (behind)</source>
        <comment>a point that the surface hides</comment>
        <translation>%1（在后面）</translation>
    </message>
    <message>
        <source>A surface hides it in this view.</source>
        <translation>它在此处可见的表面后面。</translation>
    </message>
    <message>
        <source>It is free: no anchor holds it on a surface. B puts it back.</source>
        <translation>它是自由的：没有依附元素把它固定在表面上。按 B 放回表面。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarkObjects</name>
    <message>
        <source>“%1” (%2)</source>
        <translation>“%1”（%2）</translation>
    </message>
    <message>
        <source>Landmarks whose triangle, edge or vertex does not exist: %1, such as %2.</source>
        <translation>由其物体所没有的元素固定的标志点：%1 个，如 %2。</translation>
    </message>
    <message>
        <source>Landmarks away from their anchor, as if the model had been changed: %1; %2 by %3.</source>
        <translation>不在固定它们的元素处的标志点，似乎模型已被改动：%1 个；%2 相差 %3。</translation>
    </message>
    <message>
        <source>They are free now. To put selected landmarks onto the surface, press B.</source>
        <translation>它们留在原处，不再固定；按 B 把选中的标志点放到曲面上。</translation>
    </message>
    <message>
        <source>“%1” (on “%2”)</source>
        <translation>“%1”（在“%2”上）</translation>
    </message>
    <message>
        <source>Landmarks on a missing object: %1, such as %2.</source>
        <translation>所在物体不在此场景中的标志点：%1 个，如 %2。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarkTemplates</name>
    <message>
        <source>Definitions in our own words, after Martin and Saller, Lehrbuch der Anthropologie (1957)</source>
        <translation>定义为我们自己的表述，依据 Martin 与 Saller《Lehrbuch der Anthropologie》（1957）</translation>
    </message>
    <message>
        <source>Definitions in our own words, after Farkas, Anthropometry of the Head and Face (1994)</source>
        <translation>定义为我们自己的表述，依据 Farkas《Anthropometry of the Head and Face》（1994）</translation>
    </message>
    <message>
        <source>Skull (craniometric points)</source>
        <translation>颅骨（测量点）</translation>
    </message>
    <message>
        <source>craniometric</source>
        <extracomment>The file of resources/templates with the hints in this language</extracomment>
        <translation>craniometric_zh_CN</translation>
    </message>
    <message>
        <source>Face (soft tissue)</source>
        <translation>面部（软组织）</translation>
    </message>
    <message>
        <source>facial</source>
        <extracomment>The file of resources/templates with the hints in this language</extracomment>
        <translation>facial_zh_CN</translation>
    </message>
    <message>
        <source>Template %1</source>
        <translation>模板 %1</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarkTool</name>
    <message>
        <source>Background: no surface here</source>
        <translation>背景：此处没有表面</translation>
    </message>
    <message>
        <source>A surface hides it: turn the view, or go to it (G).</source>
        <translation>它在此处所见之物的后面：请转动视图，或转到该点（G）。</translation>
    </message>
    <message>
        <source>Selected landmarks not moved, because they are hidden or outside the view: %1.</source>
        <translation>选中而未移动的标志点（在此处所见之后或之外）：%1 个。</translation>
    </message>
    <message>
        <source>The second click of a double-click places nothing.</source>
        <translation>双击的第二下不放置任何标志点。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarksFeature</name>
    <message>
        <source>Landmarks</source>
        <translation>标志点</translation>
    </message>
    <message>
        <source>Place landmarks on the surface, name and move them, and measure between them</source>
        <translation>在表面上放置标志点、命名、移动、测量</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Import Landmarks</source>
        <translation>导入标志点</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Export Landmarks</source>
        <translation>导出标志点</translation>
    </message>
    <message>
        <source>&amp;Import Landmarks…</source>
        <translation>导入标志点(&amp;I)…</translation>
    </message>
    <message>
        <source>Import landmarks from a file of this or another program</source>
        <translation>从本程序或其他程序的文件读取标志点</translation>
    </message>
    <message>
        <source>E&amp;xport Landmarks…</source>
        <translation>导出标志点(&amp;X)…</translation>
    </message>
    <message>
        <source>Export the landmarks to a file; its suffix selects the format</source>
        <translation>将标志点写入文件；由后缀决定供哪个程序使用</translation>
    </message>
    <message>
        <source>Series of S&amp;cans</source>
        <translation>扫描系列(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Open Folder…</source>
        <translation>打开文件夹(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a folder of scans and place the same landmarks on each</source>
        <translation>打开一个扫描文件夹，在每个扫描上放置相同的标志点</translation>
    </message>
    <message>
        <source>&amp;Next Scan</source>
        <translation>下一个扫描(&amp;N)</translation>
    </message>
    <message>
        <source>Keep the landmarks and show the next scan</source>
        <translation>保留各标志点并显示下一个扫描</translation>
    </message>
    <message>
        <source>&amp;Previous Scan</source>
        <translation>上一个扫描(&amp;P)</translation>
    </message>
    <message>
        <source>Keep the landmarks and show the previous scan</source>
        <translation>保留各标志点并显示上一个扫描</translation>
    </message>
    <message>
        <source>&amp;Repeats…</source>
        <translation>重复测量(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Close Series</source>
        <translation>关闭系列(&amp;C)</translation>
    </message>
    <message>
        <source>Keep the landmarks and leave the series</source>
        <translation>保存各标志点并离开此系列</translation>
    </message>
    <message>
        <source>&amp;Place Landmarks</source>
        <translation>放置标志点(&amp;P)</translation>
    </message>
    <message>
        <source>A click places a landmark; a drag turns the view</source>
        <translation>点击放置一个标志点；拖动则转动视图</translation>
    </message>
    <message>
        <source>&amp;Go to Landmark</source>
        <translation>转到该标志点(&amp;G)</translation>
    </message>
    <message>
        <source>Turn the camera to face the surface at the selected landmark</source>
        <translation>转动相机，使其正对选中标志点处的表面</translation>
    </message>
    <message>
        <source>&amp;Zoom to ± 0.01</source>
        <translation>放大到 ± 0.01(&amp;Z)</translation>
    </message>
    <message>
        <source>Move closer to the selected landmark until its pixel has an uncertainty of at most 0.01</source>
        <translation>靠近选中的标志点，直到它的像素所含的不确定不超过 0.01</translation>
    </message>
    <message>
        <source>Put &amp;Back on the Surface</source>
        <translation>放回表面(&amp;B)</translation>
    </message>
    <message>
        <source>Move the selected landmarks to the closest point of the surface</source>
        <translation>将选中的标志点放到表面上离它们最近的位置</translation>
    </message>
    <message>
        <source>&amp;Join on the Surface</source>
        <translation>沿曲面连接(&amp;J)</translation>
    </message>
    <message>
        <source>Draw a curve through the selected landmarks, like a thread pulled tight on the surface</source>
        <translation>像在曲面上拉紧的线那样，引一条曲线通过选中的标志点</translation>
    </message>
    <message>
        <source>Join Along a P&amp;lane</source>
        <translation>沿平面连接(&amp;L)</translation>
    </message>
    <message>
        <source>Draw a curve through the selected landmarks, where the plane along the surface&apos;s normals cuts it</source>
        <translation>在沿曲面法线的平面与曲面相交处，引一条曲线通过选中的标志点</translation>
    </message>
    <message>
        <source>Select a placed landmark first: its marker in the view, or its row in the Landmarks panel.</source>
        <translation>请先选择一个已放置的标志点：点击视图中的标记，或“标志点”面板中的那一行。</translation>
    </message>
    <message>
        <source>Select placed landmarks first: their markers in the view, or their rows in the Landmarks panel.</source>
        <translation>请先选择已放置的标志点：点击视图中的标记，或“标志点”面板中的各行。</translation>
    </message>
    <message>
        <source>Select two or more landmarks first: their rows in the Landmarks panel, with Ctrl.</source>
        <translation>请先选择两个或更多的标志点：按住 Ctrl 点击“标志点”面板中的各行。</translation>
    </message>
    <message>
        <source>Show how well each landmark is repeated: its error of measurement over all placings</source>
        <translation>显示每个标志点重复得多好：它在所有遍次中的测量误差</translation>
    </message>
    <message>
        <source>S&amp;kip Landmark</source>
        <translation>跳过标志点(&amp;K)</translation>
    </message>
    <message>
        <source>Go on with the next landmark to place; the skipped one comes again after the others</source>
        <translation>继续下一个要放置的标志点；跳过的在其他标志点之后再次轮到</translation>
    </message>
    <message>
        <source>Mark as &amp;Missing</source>
        <translation>标为缺失(&amp;M)</translation>
    </message>
    <message>
        <source>Mark the next landmark to place, else the selected ones, as missing on this specimen; again removes the mark</source>
        <translation>将下一个要放置的标志点标为此标本上缺失；没有时，标记选中的标志点；再按一次去掉标记</translation>
    </message>
    <message>
        <source>Turn to &amp;Expected Place</source>
        <translation>转到预期位置(&amp;E)</translation>
    </message>
    <message>
        <source>Turn the camera to face the surface where the other scans of the series expect the next landmark</source>
        <translation>转动相机，正对系列的其他扫描预期下一个标志点的表面</translation>
    </message>
    <message>
        <source>Sho&amp;w Expected Places</source>
        <translation>显示预期位置(&amp;W)</translation>
    </message>
    <message>
        <source>Show where the other scans of the series expect the landmarks to place</source>
        <translation>显示系列的其他扫描预期待放置的标志点在哪里</translation>
    </message>
    <message>
        <source>Axis Arro&amp;ws</source>
        <translation>坐标轴箭头(&amp;W)</translation>
    </message>
    <message>
        <source>Show arrows at the selected landmark that move it along the axes, off the surface</source>
        <translation>在选中的标志点处显示箭头，可沿坐标轴移动它，离开表面</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarksModel</name>
    <message>
        <source>%1 ± %2, world units</source>
        <translation>%1 ± %2，世界单位</translation>
    </message>
    <message>
        <source>%1, world units; uncertainty unknown</source>
        <translation>%1，世界单位；可能相差多少不得而知</translation>
    </message>
    <message>
        <source>%1, hidden</source>
        <translation>%1，已隐藏</translation>
    </message>
    <message>
        <source>Uncertainty in world units: √(±x² + ±y² + ±z²), from the ± of each coordinate</source>
        <translation>该点可能相差多少，世界单位：各坐标可能相差之量的长度</translation>
    </message>
    <message>
        <source>Number in the list, and in files without names</source>
        <translation>它在列表中的编号，也是没有名称的文件中的编号</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>World x; grey digits are smaller than the uncertainty</source>
        <translation>世界 x；黑色部分是确定的</translation>
    </message>
    <message>
        <source>World y; grey digits are smaller than the uncertainty</source>
        <translation>世界 y；黑色部分是确定的</translation>
    </message>
    <message>
        <source>World z; grey digits are smaller than the uncertainty</source>
        <translation>世界 z；黑色部分是确定的</translation>
    </message>
    <message>
        <source>Object under the landmark</source>
        <translation>它所在的物体</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Triangle, edge or vertex that holds the landmark</source>
        <translation>它依附于物体网格的哪一部分</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>依附于</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>This landmark is not placed yet. Type all three coordinates, as “1 2 3”, or place it in the view.</source>
        <translation>这个标志点还没有位置。请一次输入三个坐标，如“1 2 3”，或在视图中放置它。</translation>
    </message>
    <message>
        <source>The uncertainty is unknown, so all digits are grey</source>
        <translation>该点可能偏差多少未知，因此没有一位数字算是确定的</translation>
    </message>
    <message>
        <source>Uncertainty, world units: half a pixel to the side, and the click&apos;s uncertainty. The Comparison panel and the map show only the latter</source>
        <translation>此点可能偏差多远（世界单位）：侧向半个像素，再加点击本身的偏差（“比较”和不确定度图只含后者）</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarksPanel</name>
    <message>
        <source>No landmarks yet. Press P, then click the surface. Or choose a template and place its landmarks one after the other.</source>
        <translation>还没有标志点。按 P，再点击要放置的地方；或选择一个模板，依次放置其中的标志点。</translation>
    </message>
    <message>
        <source>Reason why the number was rejected</source>
        <translation>数字被拒绝的原因</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>模板</translation>
    </message>
    <message>
        <source>Names to place one after the other</source>
        <translation>依次放置的名称</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Move the selected landmark up</source>
        <translation>将所选的标志点移到上一个之前</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Move the selected landmark down</source>
        <translation>将所选的标志点移到下一个之后</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the selected landmarks (Del)</source>
        <translation>移除所选的标志点 (Del)</translation>
    </message>
    <message>
        <source>&amp;Load Template…</source>
        <translation>载入模板(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Save Names as Template…</source>
        <translation>将名称存为模板(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Place All Again</source>
        <translation>全部重新放置(&amp;P)</translation>
    </message>
    <message>
        <source>Keep the names and place every landmark again</source>
        <translation>名称保留，每个标志点重新放置</translation>
    </message>
    <message>
        <source>Load Template</source>
        <translation>载入模板</translation>
    </message>
    <message>
        <source>Templates and landmarks (%1)</source>
        <translation>模板与标志点 (%1)</translation>
    </message>
    <message>
        <source>Save Names as Template</source>
        <translation>将名称存为模板</translation>
    </message>
    <message>
        <source>MeshLab&apos;s template (%1)</source>
        <translation>MeshLab 模板 (%1)</translation>
    </message>
    <message>
        <source>Table with hints (%1)</source>
        <translation>带提示的表格 (%1)</translation>
    </message>
    <message>
        <source>Colour of Landmarks</source>
        <translation>标志点的颜色</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>颜色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>通常(&amp;U)</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>橙</translation>
    </message>
    <message>
        <source>Sky Blue</source>
        <translation>天蓝</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>朱红</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>紫</translation>
    </message>
    <message>
        <source>&amp;Other…</source>
        <translation>其他(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>显示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Place Next</source>
        <translation>下一个放置这个点(&amp;P)</translation>
    </message>
    <message>
        <source>Mark as &amp;Missing</source>
        <translation>标为缺失(&amp;M)</translation>
    </message>
    <message>
        <source>Copy as C&amp;SV</source>
        <translation>复制为 CSV(&amp;S)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>移除(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>无(&amp;N)</translation>
    </message>
    <message>
        <source>Remove the names not placed yet and place landmarks freely</source>
        <translation>去掉尚未放置的名称：自由放置各标志点</translation>
    </message>
    <message>
        <source>No landmarks yet. Click the surface. Or choose a template and place its landmarks one after the other.</source>
        <translation>还没有标志点。在要放标志点的地方单击；或选择一个模板，依次放置其中的标志点。</translation>
    </message>
    <message>
        <source>The template %1 replaced %2, which was not placed yet.</source>
        <translation>模板 %1 替换了尚未放置的 %2。</translation>
    </message>
    <message numerus="yes">
        <source>The template %1 replaced %n names that were not placed yet.</source>
        <translation>
            <numerusform>模板 %1 替换了 %n 个尚未放置的名称。</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Go to Landmark</source>
        <translation>转到该标志点(&amp;G)</translation>
    </message>
    <message>
        <source>Mark as Not &amp;Missing</source>
        <translation>去掉缺失标记(&amp;M)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LandmarksTable</name>
    <message>
        <source>Placed landmarks</source>
        <translation>已放置的标志点</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LanguageMenu</name>
    <message>
        <source>Add Chinese in Settings &gt; Time &amp; Language &gt; Language.</source>
        <translation>请在“设置 &gt; 时间和语言 &gt; 语言”中添加中文。</translation>
    </message>
    <message>
        <source>Install one, such as the package fonts-noto-cjk of Debian and Ubuntu.</source>
        <translation>请安装一种，例如 Debian 和 Ubuntu 的软件包 fonts-noto-cjk。</translation>
    </message>
    <message>
        <source>The program speaks Chinese, but no font here has its characters. %1 Then start the program again.</source>
        <translation>本程序有中文界面，但这里没有含汉字的字体。%1然后重新启动本程序。</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>The program uses the language of the desktop when it starts next time.</source>
        <translation>程序下次启动时使用桌面的语言。</translation>
    </message>
    <message>
        <source>No font here has Chinese characters. %1 Then start the program again.</source>
        <translation>这里没有含汉字的字体。%1然后重新启动本程序。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LessonPanel</name>
    <message>
        <source>‹ Back</source>
        <translation>‹ 上一步</translation>
    </message>
    <message>
        <source>Next ›</source>
        <translation>下一步 ›</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Leave the lesson and return to the scene before it</source>
        <translation>退出课程；恢复之前显示的场景</translation>
    </message>
    <message>
        <source>Leave the lesson</source>
        <translation>退出课程</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>The step of the lesson that is shown</source>
        <translation>正在显示的课程步骤</translation>
    </message>
    <message>
        <source>Explanation</source>
        <translation>观察要点</translation>
    </message>
    <message>
        <source>The previous step (Alt+Page Up)</source>
        <translation>上一步 (Alt+Page Up)</translation>
    </message>
    <message>
        <source>The next step (Alt+Page Down)</source>
        <translation>下一步 (Alt+Page Down)</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 / %2：%3</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>出处：%1</translation>
    </message>
    <message>
        <source>The view differs from the step. &lt;a href=&apos;restart:&apos;&gt;Restore it&lt;/a&gt;</source>
        <translation>画面与本步不同。&lt;a href=&apos;restart:&apos;&gt;恢复原样&lt;/a&gt;</translation>
    </message>
    <message>
        <source>The text uses the pixels of a view of &lt;a href=&apos;view:%1x%2&apos;&gt;%1 × %2&lt;/a&gt;. This view is %3 × %4.</source>
        <translation>所说的像素是 &lt;a href=&apos;view:%1x%2&apos;&gt;%1 × %2&lt;/a&gt; 的视图中的像素。现在的视图是 %3 × %4。</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Summary of the answers, and the next lesson</source>
        <translation>答题情况和下一课</translation>
    </message>
    <message>
        <source>Next lesson ›</source>
        <translation>下一课 ›</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LessonPlayer</name>
    <message>
        <source>%1.json</source>
        <extracomment>The file of a lesson in this language, in resources/lessons; %1 is its name.</extracomment>
        <translation>%1_zh_CN.json</translation>
    </message>
    <message>
        <source>The change does not fit the current scene. Restore the step&apos;s scene first. (%1)</source>
        <translation>现在的场景无法这样更改。请恢复为本步骤的场景。（%1）</translation>
    </message>
    <message>
        <source>Change by the Lesson</source>
        <translation>课程所作的更改</translation>
    </message>
    <message>
        <source>--lesson is %1; give a lesson, or one of its steps behind a colon: %2.</source>
        <extracomment>%2 are all lessons with their steps: first:1-7, weng:1-16</extracomment>
        <translation>--lesson 为 %1；请给出一门课程，或在冒号后给出其中一步：%2。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LessonsFeature</name>
    <message>
        <source>Lesson</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>&amp;Bundled Scene</source>
        <translation>自带场景(&amp;B)</translation>
    </message>
    <message>
        <source>Show the scene that comes with the program</source>
        <translation>显示程序自带的场景</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>课程(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Formulas</source>
        <translation>公式(&amp;F)</translation>
    </message>
    <message>
        <source>All formulas with their sources, and the errors in the originals</source>
        <translation>所有公式及其出处，以及原文中的错误</translation>
    </message>
    <message>
        <source>First &amp;Steps</source>
        <translation>入门(&amp;S)</translation>
    </message>
    <message>
        <source>Three things to try</source>
        <translation>可以试试这三件事</translation>
    </message>
    <message>
        <source>&amp;Next Step</source>
        <translation>下一步(&amp;N)</translation>
    </message>
    <message>
        <source>The next step of the lesson</source>
        <translation>课程的下一步</translation>
    </message>
    <message>
        <source>&amp;Previous Step</source>
        <translation>上一步(&amp;P)</translation>
    </message>
    <message>
        <source>The previous step of the lesson</source>
        <translation>课程的上一步</translation>
    </message>
    <message>
        <source>L&amp;eave Lesson</source>
        <translation>退出课程(&amp;E)</translation>
    </message>
    <message>
        <source>Leave the lesson and return to the scene before it</source>
        <translation>结束课程；恢复之前显示的场景</translation>
    </message>
    <message>
        <source>The point is outside the current view. Restore the step&apos;s view first.</source>
        <translation>该点不在现在的画面中。请恢复本步的画面。</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Lessons of a few minutes, with questions</source>
        <translation>几分钟的课程，带有问题</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LifecycleLog</name>
    <message>
        <source>From %1 s to %2 s</source>
        <translation>从 %1 s 到 %2 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>OpenGL calls</source>
        <translation>OpenGL 调用</translation>
    </message>
    <message>
        <source>Took</source>
        <translation>耗时</translation>
    </message>
    <message>
        <source>While the view moves, large models are drawn coarsely. Clicks always read the full model.</source>
        <translation>视图移动时，大模型由粗略的替身显示。点击读取的始终是完整的模型。</translation>
    </message>
    <message>
        <source>%1; in %2 of %3 frames large models were drawn coarsely</source>
        <translation>%1；%3 幅画面中有 %2 幅对大模型作了粗略绘制</translation>
    </message>
    <message>
        <source>%1; large models were drawn coarsely</source>
        <translation>%1；对大模型作了粗略绘制</translation>
    </message>
    <message>
        <source>Viewport</source>
        <translation>视口</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>The last of %1. Mean: %2 ms</source>
        <translation>%1 次中的最后一次。平均：%2 ms</translation>
    </message>
    <message>
        <source>Seconds since the view&apos;s first step; a folded row shows its first step</source>
        <translation>从视图的第一步算起的秒数；对折叠的行，为其中第一步的时刻</translation>
    </message>
    <message>
        <source>Name of the step in Weng et al. 2008 with its arguments, or the changed parameter. Sizes are in device pixels, positions in logical pixels from the top-left corner</source>
        <translation>步骤及其参数，名称依 Weng 等 (2008)（大小以设备像素计，位置以逻辑像素计，原点在左上角），或改变了的参数</translation>
    </message>
    <message>
        <source>OpenGL calls of the step, or the call that takes the parameter</source>
        <translation>该步骤所做的 OpenGL 调用，或含有该参数的调用</translation>
    </message>
    <message>
        <source>Duration of the step in milliseconds; a folded row shows its last step</source>
        <translation>该步骤的毫秒数；对折叠的行，为其中最后一步的值</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LifecyclePanel</name>
    <message>
        <source>Steps of the view&apos;s life</source>
        <translation>视图生命周期的步骤</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selected steps, or all of them, as lines of text</source>
        <translation>以文本行复制所选步骤，未选时复制全部</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>清空(&amp;L)</translation>
    </message>
    <message>
        <source>Remove all steps from the log</source>
        <translation>清除日志中的全部步骤</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>To open a row of several steps, click its arrow or press Right</source>
        <translation>代表多个步骤的行可以展开：点击其箭头，或按右方向键</translation>
    </message>
    <message>
        <source>The current step with all its calls</source>
        <translation>当前步骤及其全部调用</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::LoadingBar</name>
    <message>
        <source>Opening</source>
        <translation>正在打开</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Opening …</source>
        <translation>正在打开…</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>正在打开 %1</translation>
    </message>
    <message>
        <source>Stop opening and keep the scene as it is (Esc)</source>
        <translation>停止打开，保持场景不变（Esc）</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>正在绘制…</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>正在绘制</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MainWindow</name>
    <message>
        <source>Unprojector</source>
        <translation>Unprojector</translation>
    </message>
    <message>
        <source>%1[*] – Unprojector</source>
        <translation>%1[*] – Unprojector</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ManualWindow</name>
    <message>
        <source>Manual</source>
        <extracomment>The folder of the manual&apos;s pages in this language, in resources: manual/zh_CN.</extracomment>
        <translation>手册</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>manual/zh_CN</translation>
    </message>
    <message>
        <source>Go Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Back to the place before</source>
        <translation>回到前一处</translation>
    </message>
    <message>
        <source>Go Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>Forward to the place that was left last</source>
        <translation>前往刚才离开的那一处</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Back to the contents</source>
        <translation>返回目录</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search all pages</source>
        <translation>搜索所有页面</translation>
    </message>
    <message>
        <source>Words; the list shows the pages and headings that have all of them. Enter opens the first one</source>
        <translation>输入词语；列表显示包含全部词语的页面和标题，按 Enter 打开第一个</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>没有页面包含这些词。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MapFeature</name>
    <message>
        <source>Show for every pixel the difference of the methods, the uncertainty of a click, or the error of another program</source>
        <translation>在视图上显示每个像素处两种方法相差多少、点击有多确定，或其他程序偏差多少</translation>
    </message>
    <message>
        <source>Export Map</source>
        <translation>导出映射图</translation>
    </message>
    <message>
        <source>Image with its scale (*.png)</source>
        <translation>带刻度的图像 (*.png)</translation>
    </message>
    <message>
        <source>Float map (*.pfm)</source>
        <translation>浮点图 (*.pfm)</translation>
    </message>
    <message>
        <source>Map written to %1</source>
        <translation>映射图已写入 %1</translation>
    </message>
    <message>
        <source>&amp;Error Map</source>
        <translation>误差图(&amp;M)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MapOverlay</name>
    <message>
        <source>The map appears when the view stops moving.</source>
        <translation>视图静止后显示映射图。</translation>
    </message>
    <message>
        <source>Computing the map: %1 %</source>
        <translation>正在计算映射图：%1 %</translation>
    </message>
    <message>
        <source>This view has no such map: %1</source>
        <translation>此画面没有这种映射图：%1</translation>
    </message>
    <message>
        <source>There is no map: %1. Make the window smaller, or close other programs.</source>
        <translation>没有映射图：%1。请缩小窗口，或关闭其他程序。</translation>
    </message>
    <message>
        <source>Computing the map…</source>
        <translation>正在计算映射图…</translation>
    </message>
    <message>
        <source>There is no map, because the model is not prepared for rays: %1.</source>
        <translation>未能为射线准备模型，因此没有映射图：%1。</translation>
    </message>
    <message>
        <source>The map appears when the model is prepared for rays.</source>
        <translation>模型为射线准备好后显示映射图。</translation>
    </message>
    <message>
        <source>No pixel has a value.</source>
        <translation>没有像素有数值。</translation>
    </message>
    <message>
        <source>%1 pixels: median %2, 99 % at most %3, greatest %4</source>
        <translation>%1 个像素：中位数 %2，99 % 不超过 %3，最大 %4</translation>
    </message>
    <message>
        <source>no number here</source>
        <translation>此处无数值</translation>
    </message>
    <message>
        <source>here: %1</source>
        <translation>此处：%1</translation>
    </message>
    <message>
        <source>There is no map to export.</source>
        <translation>没有可写出的映射图。</translation>
    </message>
    <message>
        <source>%1: maps are written as .png or .pfm. End the name with one of these.</source>
        <translation>%1：映射图写为 .png 或 .pfm；请给文件名加上其中一个后缀。</translation>
    </message>
    <message>
        <source>%1 pixels: no difference beyond rounding.</source>
        <translation>%1 个像素：除舍入外没有差别。</translation>
    </message>
    <message>
        <source>It is the length of the ± that the Comparison panel shows for a click there. Half a step of the depth buffer is a part of it. The ± of a landmark adds half a pixel to the side.</source>
        <translation>这是“比较”对该处点击所给 ± 的长度。深度缓冲区的半步只是其中一部分；放置的标志点的 ± 还另含侧向半个像素。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MapPanel</name>
    <message>
        <source>E&amp;xport…</source>
        <translation>导出(&amp;X)…</translation>
    </message>
    <message>
        <source>Quantity that the map shows</source>
        <translation>映射图显示什么</translation>
    </message>
    <message>
        <source>Program or mistake of the displacement</source>
        <translation>谁的偏移</translation>
    </message>
    <message>
        <source>Program that answers, or mistake that is made</source>
        <translation>由哪个程序给出，或犯了哪个错误</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>World units, or units in the last place of the point&apos;s largest coordinate</source>
        <translation>世界单位，或点的最大坐标的末位单位</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Colours from dark to light, also for colour-blind users</source>
        <translation>由深到浅的颜色，色盲者也能分辨</translation>
    </message>
    <message>
        <source>The map&apos;s number under the pointer</source>
        <translation>指针处的数值</translation>
    </message>
    <message>
        <source>The map&apos;s numbers</source>
        <translation>映射图的数值</translation>
    </message>
    <message>
        <source>Write the map as an image with its scale (PNG), or as numbers (PFM)</source>
        <translation>把映射图写成带刻度的图像（PNG）或数值（PFM）</translation>
    </message>
    <message>
        <source>Close the map</source>
        <translation>移除映射图</translation>
    </message>
    <message>
        <source>Displacement: %1</source>
        <translation>偏移：%1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MapText</name>
    <message>
        <source>single precision</source>
        <translation>单精度</translation>
    </message>
    <message>
        <source>Formula − matrix</source>
        <translation>公式 − 矩阵</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>不确定度</translation>
    </message>
    <message>
        <source>Displacement by…</source>
        <translation>偏移，来自…</translation>
    </message>
    <message>
        <source>Distance between the points of the formulas and of the inverted matrix</source>
        <translation>公式的点与逆矩阵的点相距多远</translation>
    </message>
    <message>
        <source>Distance from the formulas&apos; point to the hit of the pixel&apos;s ray on the mesh</source>
        <translation>公式的点与像素射线在网格上的交点相距多远</translation>
    </message>
    <message>
        <source>Distance from the inverted matrix&apos;s point to the hit of the pixel&apos;s ray on the mesh</source>
        <translation>逆矩阵的点与像素射线在网格上的交点相距多远</translation>
    </message>
    <message>
        <source>Distance from the formulas&apos; point to the answer of another program, or of a program with a mistake</source>
        <translation>其他程序或带有某个错误的程序所得的点与公式的点相距多远</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>世界单位</translation>
    </message>
    <message>
        <source>ulps</source>
        <translation>ulp</translation>
    </message>
    <message>
        <source>The paper, literally</source>
        <translation>论文（照字面）</translation>
    </message>
    <message>
        <source>(7) and (8) with whole pixels: the pixel&apos;s upper left corner, half a pixel left and up of its centre</source>
        <translation>式 (7)、(8) 代入整数像素：取像素左上角，比中心偏左、偏上半个像素</translation>
    </message>
    <message>
        <source>The tutorial&apos;s function flips y with the viewport&apos;s height, unprojects the pixel&apos;s corner, and reads the depth of the row above</source>
        <translation>教程的函数用视口高度翻转 y，反投影像素的角点，并读取上一行的深度</translation>
    </message>
    <message>
        <source>Height − y without the 1: unprojects the pixel&apos;s upper left corner with the depth of the row above</source>
        <translation>用 高度 − y 而未减 1：以上一行的深度反投影像素的左上角</translation>
    </message>
    <message>
        <source>Unprojects the pixel&apos;s lower left corner, half a pixel left and down of its centre</source>
        <translation>反投影像素的左下角，比中心偏左、偏下半个像素</translation>
    </message>
    <message>
        <source>Unprojects the pixel&apos;s upper left corner, half a pixel left and up of its centre</source>
        <translation>反投影像素的左上角，比中心偏左、偏上半个像素</translation>
    </message>
    <message>
        <source>Divides by the size less one: right in the middle of the viewport, half a pixel off at its edges</source>
        <translation>除以尺寸减一：视口中央正确，边缘偏差半个像素</translation>
    </message>
    <message>
        <source>Greatest distance of the surface from the point of a click: the length of its ± in the Comparison panel. The ± of a landmark adds half a pixel to the side</source>
        <translation>曲面离点击所得的点最远可能有多远：即“比较”面板中 ± 的长度。标志点的 ± 还另含侧向半个像素</translation>
    </message>
    <message>
        <source>takes the pixel&apos;s upper left corner</source>
        <translation>取像素的左上角</translation>
    </message>
    <message>
        <source>flips y by the viewport&apos;s height</source>
        <translation>按视口的高翻转 y</translation>
    </message>
    <message>
        <source>forgets the 1 in height − 1 − y</source>
        <translation>漏掉 高 − 1 − y 中的 1</translation>
    </message>
    <message>
        <source>takes the pixel&apos;s lower left corner</source>
        <translation>取像素的左下角</translation>
    </message>
    <message>
        <source>divides by the size less one</source>
        <translation>除以尺寸减一</translation>
    </message>
    <message>
        <source>Formula − exact hit</source>
        <translation>公式 − 精确交点</translation>
    </message>
    <message>
        <source>Matrix − exact hit</source>
        <translation>矩阵 − 精确交点</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MatrixModel</name>
    <message>
        <source>row %1, column %2, m[%3]</source>
        <translation>第 %1 行，第 %2 列，m[%3]</translation>
    </message>
    <message>
        <source>%1, always
%2</source>
        <translation>%1，恒定
%2</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MatrixSection</name>
    <message>
        <source>&amp;Text</source>
        <translation>文本(&amp;T)</translation>
    </message>
    <message>
        <source>Four aligned lines, as shown</source>
        <translation>对齐的四行，如所显示</translation>
    </message>
    <message>
        <source>&amp;C array</source>
        <translation>&amp;C 数组</translation>
    </message>
    <message>
        <source>m[16] as OpenGL stores it, column after column</source>
        <translation>OpenGL 存储的 m[16]，逐列排列</translation>
    </message>
    <message>
        <source>&amp;GLM</source>
        <translation>&amp;GLM</translation>
    </message>
    <message>
        <source>A constructor, column after column</source>
        <translation>构造函数，逐列排列</translation>
    </message>
    <message>
        <source>&amp;NumPy</source>
        <translation>&amp;NumPy</translation>
    </message>
    <message>
        <source>np.array, row after row as shown</source>
        <translation>np.array，按显示逐行排列</translation>
    </message>
    <message>
        <source>&amp;LaTeX</source>
        <translation>&amp;LaTeX</translation>
    </message>
    <message>
        <source>A bmatrix, row after row as shown</source>
        <translation>bmatrix，按显示逐行排列</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the matrix with all its digits</source>
        <translation>复制带全部数位的矩阵</translation>
    </message>
    <message>
        <source>Rows and columns of the matrix; Copy takes the selected numbers with all digits</source>
        <translation>矩阵的行和列；“复制”取所选数值的全部数位</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>复制%1</translation>
    </message>
    <message>
        <source>C&amp;SV</source>
        <translation>CSV(&amp;S)</translation>
    </message>
    <message>
        <source>Four lines of numbers with commas, as shown</source>
        <translation>四行以逗号分隔的数字，按显示的排列</translation>
    </message>
    <message>
        <source>Decompose</source>
        <translation>分解</translation>
    </message>
    <message>
        <source>Show the factors of the matrix and the effect of each</source>
        <translation>显示组成此矩阵的各因子，以及各自的作用</translation>
    </message>
    <message>
        <source>Decompose %1</source>
        <translation>分解%1</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MatrixText</name>
    <message>
        <source>View or modelview</source>
        <translation>观察或模型视图</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Product (MVP)</source>
        <translation>乘积（MVP）</translation>
    </message>
    <message>
        <source>Read as Row-major</source>
        <translation>按行优先读取</translation>
    </message>
    <message>
        <source>Read as Column-major</source>
        <translation>按列优先读取</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>取它的逆</translation>
    </message>
    <message>
        <source>Swap Them</source>
        <translation>互换</translation>
    </message>
    <message>
        <source>Keep 0 to 1</source>
        <translation>保持 0 到 1</translation>
    </message>
    <message>
        <source>Read as 0 to 1</source>
        <translation>按 0 到 1 读取</translation>
    </message>
    <message>
        <source>Flip y</source>
        <translation>把 y 反回来</translation>
    </message>
    <message>
        <source>Flip x</source>
        <translation>把 x 反回来</translation>
    </message>
    <message>
        <source>Remove the Scale</source>
        <translation>去掉缩放</translation>
    </message>
    <message>
        <source>Make Perpendicular</source>
        <translation>使之正交</translation>
    </message>
    <message>
        <source>Negate</source>
        <translation>改变符号</translation>
    </message>
    <message>
        <source>Turn to −z</source>
        <translation>转向 −z</translation>
    </message>
    <message>
        <source>The depth range is reversed to match.</source>
        <translation>深度范围已为它反转。</translation>
    </message>
    <message>
        <source>It is drawn up to one million times near.</source>
        <translation>绘制到近平面的一百万倍处为止。</translation>
    </message>
    <message>
        <source>Choose the order in which your program prints it.</source>
        <translation>请选择您的程序输出它的次序。</translation>
    </message>
    <message>
        <source>Paste only the view.</source>
        <translation>请只粘贴观察矩阵。</translation>
    </message>
    <message>
        <source>It %1.</source>
        <comment>a matrix: the finding about it</comment>
        <translation>%1。</translation>
    </message>
    <message>
        <source>The window cannot show it; only the inverted matrix can answer.</source>
        <translation>窗口无法显示它；只有逆矩阵能给出答案。</translation>
    </message>
    <message>
        <source>The program&apos;s world may be left-handed. “Flip x” keeps the coordinates of that world and mirrors the image; it is then not the program&apos;s camera.</source>
        <translation>该程序的世界可能是左手系。“把 x 反回来”保留那个世界的坐标并镜像图像；这样就不再是该程序的相机。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::Measures</name>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>在 %1</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>%1 over the plane %2</source>
        <translation>%1 到平面 %2</translation>
    </message>
    <message>
        <source>Length along</source>
        <translation>折线长度</translation>
    </message>
    <message>
        <source>Mirror plane</source>
        <translation>镜像平面</translation>
    </message>
    <message>
        <source>too few pairs; place more left and right landmarks</source>
        <translation>目前没有哪个平面更好；请放置更多左右成对的标志点</translation>
    </message>
    <message>
        <source>normal (%1, %2, %3)</source>
        <translation>法线 (%1, %2, %3)</translation>
    </message>
    <message>
        <source>offset %1</source>
        <translation>偏移 %1</translation>
    </message>
    <message>
        <source>Asymmetry</source>
        <translation>不对称</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>Along the surface</source>
        <translation>沿曲面</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>pairs: %1</source>
        <translation>成对：%1</translation>
    </message>
    <message>
        <source>pairs: %1; in the middle: %2</source>
        <translation>成对：%1；视为位于正中：%2</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>由此得出</translation>
    </message>
    <message>
        <source>Without ±</source>
        <translation>没有 ±</translation>
    </message>
    <message>
        <source>leave the errors open</source>
        <translation>使误差无法确定</translation>
    </message>
    <message>
        <source>%1 is hidden</source>
        <translation>%1 已隐藏</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>未计入</translation>
    </message>
    <message>
        <source>no partner on the other side</source>
        <translation>另一侧没有对应点</translation>
    </message>
    <message>
        <source>not placed yet: %1</source>
        <translation>尚未放置：%1</translation>
    </message>
    <message>
        <source>missing on this specimen: %1</source>
        <translation>此标本上缺失：%1</translation>
    </message>
    <message>
        <source>Plane distance</source>
        <translation>到平面的距离</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MeasuresView</name>
    <message>
        <source>Measured quantity</source>
        <translation>测量什么</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>所选</translation>
    </message>
    <message>
        <source>Distances, angles and heights of the selected landmarks</source>
        <translation>所选各标志点的距离、角度和高度</translation>
    </message>
    <message>
        <source>Left and Right</source>
        <translation>左与右</translation>
    </message>
    <message>
        <source>Landmarks whose names differ only in left and right, and the plane that mirrors them best</source>
        <translation>名称只差“左”“右”（left、right）的标志点，以及使它们最好地互为镜像的平面</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>标志点</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Unit of the scene</source>
        <translation>场景的单位</translation>
    </message>
    <message>
        <source>Length of a world unit of this scene; coordinates are not converted</source>
        <translation>本场景的一个世界单位是什么；不作任何换算</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>世界单位</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>No pairs. Give landmarks names that differ only in “left” and “right”, as “eye left” and “eye right”.</source>
        <translation>没有成对的标志点：请让名称只差“左”和“右”，如“左外眼角”和“右外眼角”；“left”和“right”亦可。</translation>
    </message>
    <message>
        <source>Select two or more landmarks to measure between them.</source>
        <translation>选择两个或更多的标志点即可测量。</translation>
    </message>
    <message>
        <source>Copy as C&amp;SV</source>
        <translation>复制为 CSV(&amp;S)</translation>
    </message>
    <message>
        <source>Select a measure to show it in the view; select it again to hide it</source>
        <translation>在此选中的量显示在视图中；再点一次则不显示</translation>
    </message>
    <message>
        <source>Geodesic of the mesh from landmark to landmark, like a thread pulled tight, exact to rounding for the triangles. Around a hole or a hill it follows the shortest of the paths over sample points on the edges.</source>
        <translation>标志点之间为网格的测地线：如同在三角形上拉紧的线，对这些三角形精确到舍入误差。绕过孔洞或隆起时，取经由边上各采样点的路径中最短的一条。</translation>
    </message>
    <message>
        <source>A landmark without left or right in its name counts as in the middle. A hidden landmark is left out.</source>
        <translation>名称中没有左右之分的标志点视为位于正中。隐藏的标志点不计入。</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <comment>what is measured, of which points, its value</comment>
        <translation>%1 %2：%3</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>测量方案</translation>
    </message>
    <message>
        <source>Kept measures: each is measured on every scan of a series, and a column of its tables</source>
        <translation>保留的测量值：在系列的每个扫描上测量，并成为其表格的列</translation>
    </message>
    <message>
        <source>&amp;Load Protocol…</source>
        <translation>载入测量方案(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Save Protocol…</source>
        <translation>保存测量方案(&amp;S)…</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>what is shown, of which landmarks</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>The distance of a landmark of the middle from the mirror plane. Its mirror image is twice as far.</source>
        <translation>正中的标志点到镜像平面的距离。它的镜像有两倍远。</translation>
    </message>
    <message>
        <source>The distance of a landmark&apos;s mirror image from its partner.</source>
        <translation>标志点的镜像到其对应点的距离。</translation>
    </message>
    <message>
        <source>No measures kept yet. Select landmarks, choose a measure under Selected, and press Keep.</source>
        <translation>尚未保留测量值。请选中标志点，在“所选”中选择一个测量值，然后按“保留”。</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Compute Again</source>
        <translation>重新计算(&amp;C)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Remove the chosen measure from the protocol</source>
        <translation>把所选的测量值从测量方案中移除</translation>
    </message>
    <message>
        <source>Keep the chosen measure in the protocol</source>
        <translation>把所选的测量值保留在测量方案中</translation>
    </message>
    <message>
        <source>Choose a measure in the list first.</source>
        <translation>请先在列表中选择一个测量值。</translation>
    </message>
    <message>
        <source>Remove measure %1</source>
        <translation>移除测量值 %1</translation>
    </message>
    <message>
        <source>A kept measure knows its landmarks by name. Give each of them a name of its own.</source>
        <translation>保留的测量值按名称认识它的标志点。请给每个标志点各取一个名称。</translation>
    </message>
    <message>
        <source>This measure has no value yet, so it cannot be kept.</source>
        <translation>这个测量值还没有值，因此不能保留。</translation>
    </message>
    <message>
        <source>Keep measure %1</source>
        <translation>保留测量值 %1</translation>
    </message>
    <message>
        <source>There is a measure of this name already.</source>
        <translation>已有这个名称的测量值。</translation>
    </message>
    <message>
        <source>Rename measure</source>
        <translation>重命名测量值</translation>
    </message>
    <message>
        <source>Load Protocol</source>
        <translation>载入测量方案</translation>
    </message>
    <message>
        <source>Protocol (%1)</source>
        <translation>测量方案 (%1)</translation>
    </message>
    <message>
        <source>Load protocol</source>
        <translation>载入测量方案</translation>
    </message>
    <message>
        <source>Save Protocol</source>
        <translation>保存测量方案</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MeshEdges</name>
    <message>
        <source>The edges of %1 are not drawn: the graphics driver takes at most %2 numbers of a mesh.</source>
        <translation>%1 的边未画出：显卡驱动对每个网格最多接受 %2 个数。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
    <message>
        <source>The whole message</source>
        <translation>完整消息</translation>
    </message>
    <message>
        <source>Show less</source>
        <translation>收起</translation>
    </message>
    <message>
        <source>Show all %1 lines</source>
        <translation>显示全部 %1 行</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ModelGroup</name>
    <message>
        <source>Remove object</source>
        <translation>移除物体</translation>
    </message>
    <message>
        <source>Remove this object from the scene</source>
        <translation>从场景中移除此物体</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Object that these steps move</source>
        <translation>由这些步骤放置的物体</translation>
    </message>
    <message>
        <source>+ Translate</source>
        <translation>+ 平移</translation>
    </message>
    <message>
        <source>Add translate</source>
        <translation>添加平移</translation>
    </message>
    <message>
        <source>Add a glTranslate after the last step</source>
        <translation>在最后一步之后添加 glTranslate</translation>
    </message>
    <message>
        <source>+ Rotate</source>
        <translation>+ 旋转</translation>
    </message>
    <message>
        <source>Add rotate</source>
        <translation>添加旋转</translation>
    </message>
    <message>
        <source>Add a glRotate after the last step</source>
        <translation>在最后一步之后添加 glRotate</translation>
    </message>
    <message>
        <source>+ Scale</source>
        <translation>+ 缩放</translation>
    </message>
    <message>
        <source>Add scale</source>
        <translation>添加缩放</translation>
    </message>
    <message>
        <source>Add a glScale after the last step</source>
        <translation>在最后一步之后添加 glScale</translation>
    </message>
    <message>
        <source>Reorder steps</source>
        <translation>调整步骤顺序</translation>
    </message>
    <message>
        <source>Remove step</source>
        <translation>移除步骤</translation>
    </message>
    <message>
        <source>The scene has no objects.</source>
        <translation>没有可放置的物体。</translation>
    </message>
    <message>
        <source>No steps: the object has the coordinates of its file.</source>
        <translation>没有步骤：物体位于其文件给出的位置。</translation>
    </message>
    <message>
        <source>In the order of the calls: the last step is applied to the object first.</source>
        <translation>按调用的顺序排列：最后一步最先作用于物体。</translation>
    </message>
    <message>
        <source>Call of step %1</source>
        <translation>步骤 %1 的调用</translation>
    </message>
    <message>
        <source>Move step %1 up</source>
        <translation>上移步骤 %1</translation>
    </message>
    <message>
        <source>Call this step earlier</source>
        <translation>提前执行此调用</translation>
    </message>
    <message>
        <source>Move step %1 down</source>
        <translation>下移步骤 %1</translation>
    </message>
    <message>
        <source>Call this step later</source>
        <translation>推后执行此调用</translation>
    </message>
    <message>
        <source>Remove step %1</source>
        <translation>移除步骤 %1</translation>
    </message>
    <message>
        <source>Remove this step</source>
        <translation>移除此步骤</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Rotation angle</source>
        <translation>旋转角</translation>
    </message>
    <message>
        <source>Rotation axis %1</source>
        <translation>旋转轴 %1</translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise seen against the axis (glRotate: angle)</source>
        <translation>角度，以度计，迎着旋转轴看为逆时针 (glRotate: angle)</translation>
    </message>
    <message>
        <source>Axis of the rotation, %1; its length does not matter (glRotate: %1)</source>
        <translation>旋转轴的 %1 分量；长度无关紧要 (glRotate: %1)</translation>
    </message>
    <message>
        <source>Factor along %1, not 0 (glScale: %1)</source>
        <translation>沿 %1 的缩放系数，不能为 0 (glScale: %1)</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>步骤 %1：%2</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Position of each object (glTranslate, glRotate, glScale)</source>
        <translation>各物体的位置 (glTranslate, glRotate, glScale)</translation>
    </message>
    <message>
        <source>No steps: the shown object has the coordinates of its file</source>
        <translation>没有步骤：所示物体位于其文件给出的位置</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>倍数</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Offset along %1, world units (glTranslate: %1)</source>
        <translation>沿 %1 的偏移，世界单位 (glTranslate: %1)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::NextLandmarkBar</name>
    <message>
        <source>Landmark to place next</source>
        <translation>下一个要放置的标志点</translation>
    </message>
    <message>
        <source>Definition of the landmark</source>
        <translation>它在哪里</translation>
    </message>
    <message>
        <source>Number of placed landmarks</source>
        <translation>已放置多少个标志点</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>下一个：%1</translation>
    </message>
    <message>
        <source>Image from the template</source>
        <translation>模板中的图像</translation>
    </message>
    <message>
        <source>The image %1 cannot be shown: %2.</source>
        <translation>无法显示图像 %1：%2。</translation>
    </message>
    <message>
        <source>Instruction for placing</source>
        <translation>如何放置</translation>
    </message>
    <message>
        <source>Press P, then click its position.</source>
        <translation>按 P，再点击它所在之处。</translation>
    </message>
    <message>
        <source>Click its position; P or Esc ends placing.</source>
        <translation>点击它所在的位置；按 P 或 Esc 结束放置。</translation>
    </message>
    <message>
        <source>Go on with the next one; this one comes again after the others (K)</source>
        <translation>继续下一个；这个点在其他标志点之后再次轮到（K）</translation>
    </message>
    <message>
        <source>Missing</source>
        <comment>button: mark the landmark as missing</comment>
        <translation>缺失</translation>
    </message>
    <message>
        <source>Mark this one as missing on this specimen, and go on with the next (X)</source>
        <translation>标明此标本上没有这个点，继续下一个（X）</translation>
    </message>
    <message>
        <source>A click places a further landmark; P or Esc ends placing.</source>
        <translation>点击即放置另一个标志点；按 P 或 Esc 结束放置。</translation>
    </message>
    <message>
        <source>To place further landmarks, press P.</source>
        <translation>要放置更多标志点，请按 P。</translation>
    </message>
    <message>
        <source>All landmarks are placed</source>
        <translation>全部标志点已放置</translation>
    </message>
    <message>
        <source>All landmarks are placed or missing</source>
        <translation>全部标志点已放置或缺失</translation>
    </message>
    <message>
        <source>%1 of %2 placed</source>
        <translation>已放置 %1 / %2</translation>
    </message>
    <message>
        <source>, %1 missing</source>
        <comment>after the number of placed landmarks</comment>
        <translation>，%1 个缺失</translation>
    </message>
    <message>
        <source>, %1 skipped</source>
        <comment>after the number of placed landmarks</comment>
        <translation>，%1 个已跳过</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::NoteTexts</name>
    <message>
        <source>%1: %2</source>
        <comment>a file: the message about it</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::NumberGrid</name>
    <message>
        <source>T&amp;ype a number…</source>
        <translation>键入数值(&amp;Y)…</translation>
    </message>
    <message>
        <source>&amp;Paste all coordinates</source>
        <translation>粘贴全部坐标(&amp;P)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ObjectsFeature</name>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ObjectsModel</name>
    <message>
        <source>comes with the program</source>
        <translation>随程序提供</translation>
    </message>
    <message>
        <source>hidden: neither drawn nor clicked</source>
        <translation>已隐藏：既不绘制，也不能点选</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>An object needs a name. The old name is kept.</source>
        <translation>物体需要名称：已保留原名。</translation>
    </message>
    <message>
        <source>Another object is already called “%1”. Choose another name.</source>
        <translation>已有另一个物体名为“%1”。请另取一个名称。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ObjectsPanel</name>
    <message>
        <source>Objects of the scene</source>
        <translation>场景中的物体</translation>
    </message>
    <message>
        <source>Reason why the name was rejected</source>
        <translation>名称被拒绝的原因</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Move the camera so that this object fills the view</source>
        <translation>看向该物体，使其充满视图</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove this object from the scene (Del)</source>
        <translation>把该物体从场景中移除（Del）</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show All Objects</source>
        <translation>显示全部物体</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ObserverPanel</name>
    <message>
        <source>From eye space to the canonical view volume</source>
        <translation>从观察坐标系到规范视景体</translation>
    </message>
    <message>
        <source>Morph the view from eye space (left, 0 %) into the canonical view volume (right, 100 %).
The view volume becomes the cube [−1, 1]³ of NDC; straight lines stay straight.
The cube&apos;s z axis points away from the eye, because NDC is left-handed.</source>
        <translation>让画面从观察坐标系（左端，0 %）渐变到规范视景体（右端，100 %）。
视景体变为 NDC 的立方体 [−1, 1]³；直线仍是直线。
立方体的 z 轴背离视点，因为 NDC 是左手系。</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Progress of the morph to the canonical view volume</source>
        <translation>到规范视景体的进度</translation>
    </message>
    <message>
        <source>Play the morph to the other end</source>
        <translation>播放渐变，直到另一端</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>适合(&amp;I)</translation>
    </message>
    <message>
        <source>Show the eye and the view volume fully (F in the view)</source>
        <translation>完整显示视点和视景体（在视图中按 F）</translation>
    </message>
    <message>
        <source>Eye space</source>
        <translation>观察坐标系</translation>
    </message>
    <message>
        <source>Before the projection: lengths and angles are true</source>
        <translation>场景的原样：长度和角度是真实的</translation>
    </message>
    <message>
        <source>Canonical view volume</source>
        <translation>规范视景体</translation>
    </message>
    <message>
        <source>After the projection: NDC, each coordinate from −1 to 1</source>
        <translation>投影之后的样子：NDC，各坐标从 −1 到 1</translation>
    </message>
    <message>
        <source>Distance of the plane from the eye in world units. Drag one of its edges in the view to change it.</source>
        <translation>该平面到视点的距离，世界单位。在视图中拖动它的边即可改变。</translation>
    </message>
    <message>
        <source>Near: projection window</source>
        <translation>近：投影窗口</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>Ray of the clicked pixel</source>
        <translation>所点击像素的射线</translation>
    </message>
    <message>
        <source>From the eye (orthographic: from the near plane) through the clicked pixel to the far plane, and whether it hits a surface</source>
        <translation>从视点（长方体视景体：从近平面）经过所点击的像素到远平面，以及它是否碰到表面</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>hit</source>
        <translation>命中</translation>
    </message>
    <message>
        <source>no hit</source>
        <translation>未命中</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>停止(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close the view from outside (0)</source>
        <translation>关闭“从外部观察”（0）</translation>
    </message>
    <message>
        <source>Move into its own panel</source>
        <translation>放入单独的面板</translation>
    </message>
    <message>
        <source>Move back into the corner of the view</source>
        <translation>放回视图的一角</translation>
    </message>
    <message>
        <source>× out of sight: show it</source>
        <translation>× 在画面之外：显示它</translation>
    </message>
    <message>
        <source>Your program&apos;s point is outside this view. Move back until it is visible</source>
        <translation>您的程序得到的点在这幅画面之外。向后退，直到看得见它</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ObserverView</name>
    <message>
        <source>Observer view</source>
        <translation>外部观察视图</translation>
    </message>
    <message>
        <source>The camera and its view volume from outside. Arrow keys turn the view, plus and minus zoom, F fits it.</source>
        <translation>从外部看相机及其视景体。方向键转动视图，加号和减号缩放，F 适合窗口。</translation>
    </message>
    <message>
        <source>Near plane</source>
        <translation>近平面</translation>
    </message>
    <message>
        <source>Far plane</source>
        <translation>远平面</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::OtherProgramsView</name>
    <message>
        <source>Other programs</source>
        <translation>其他程序</translation>
    </message>
    <message>
        <source>Because it</source>
        <translation>因为它</translation>
    </message>
    <message>
        <source>Distance from the formula&apos;s point; world units</source>
        <translation>与公式所得点的距离；世界单位</translation>
    </message>
    <message>
        <source>Click a surface to see them.</source>
        <translation>点击曲面即可看到。</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>The depth that it reads is not known.</source>
        <translation>它读取的深度未知。</translation>
    </message>
    <message>
        <source>Its point and its reason</source>
        <translation>它的点和原因</translation>
    </message>
    <message>
        <source>It gets %1.</source>
        <translation>它得到 %1。</translation>
    </message>
    <message>
        <source>Select a row to read its point and its reason.</source>
        <translation>选中一行可读它的点和原因。</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::OutsideFeature</name>
    <message>
        <source>View from Outside</source>
        <translation>从外部观察</translation>
    </message>
    <message>
        <source>&amp;View from Outside</source>
        <translation>从外部观察(&amp;V)</translation>
    </message>
    <message>
        <source>Show the camera and its view volume from outside, in a corner of the view or in a panel</source>
        <translation>在视图的一角或面板中，从外部显示相机及其视景体</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PanelHelp</name>
    <message>
        <source>Manual: %1</source>
        <translation>手册：%1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ParameterGroup</name>
    <message>
        <source>%1 is empty; type a number.</source>
        <translation>%1为空；请输入一个数。</translation>
    </message>
    <message>
        <source>%1 is valid now; press Enter.</source>
        <translation>%1现在可以接受；请按回车键。</translation>
    </message>
    <message>
        <source>Reason why the change was rejected</source>
        <translation>未作更改的原因</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>重置%1</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>世界单位</translation>
    </message>
    <message>
        <source>eye units</source>
        <translation>观察坐标单位</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>device px</source>
        <translation>设备像素</translation>
    </message>
    <message>
        <source>w : h</source>
        <translation>宽 : 高</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ParameterRow</name>
    <message>
        <source>Reason why the number was rejected</source>
        <translation>该数不被接受的原因</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ParametersFeature</name>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ParametersPanel</name>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PasteCameraDialog</name>
    <message>
        <source>Not a camera: %1</source>
        <translation>不是相机：%1</translation>
    </message>
    <message>
        <source>Paste Camera</source>
        <translation>粘贴相机</translation>
    </message>
    <message>
        <source>Files of the camera</source>
        <translation>相机的文件</translation>
    </message>
    <message>
        <source>&amp;Type instead</source>
        <translation>改为键入(&amp;T)</translation>
    </message>
    <message>
        <source>Forget the files and read pasted texts again</source>
        <translation>不用这些文件，重新读取粘贴的文本</translation>
    </message>
    <message>
        <source>Open &amp;File…</source>
        <translation>打开文件(&amp;F)…</translation>
    </message>
    <message>
        <source>Read a camera&apos;s file, or several that belong together (COLMAP). Files can be dropped here</source>
        <translation>读取一个相机文件，或几个同属的文件（COLMAP）。也可以把文件拖到这里</translation>
    </message>
    <message>
        <source>Open a Camera</source>
        <translation>打开相机</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>%1 is larger than 256 MiB: it is no camera&apos;s file.</source>
        <translation>%1 大于 256 MiB：它不是相机文件。</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>无法读取 %1：%2。</translation>
    </message>
    <message>
        <source>Text with a camera</source>
        <translation>含相机的文本</translation>
    </message>
    <message>
        <source>Paste a camera as a program prints it:

K, R and t, OpenCV&apos;s YAML, transforms.json …
matrices: NumPy, Eigen, glm::to_string, JSON, C …
calls: gluPerspective(45, 1.5, 0.1, 100)</source>
        <translation>按程序打印的样子粘贴相机：

K、R 和 t，OpenCV 的 YAML，transforms.json …
矩阵：NumPy、Eigen、glm::to_string、JSON、C …
调用：gluPerspective(45, 1.5, 0.1, 100)</translation>
    </message>
    <message>
        <source>How the text is read</source>
        <translation>文本如何读取</translation>
    </message>
    <message>
        <source>Set the scene&apos;s camera from this text; Ctrl+Z undoes it</source>
        <translation>按此文本设置场景的相机；Ctrl+Z 可撤销</translation>
    </message>
    <message>
        <source>The text has %1 characters; at most %2 can be pasted. Save it as a file, and open that.</source>
        <translation>文本有 %1 个字符；最多可粘贴 %2 个。请存为文件，再打开它。</translation>
    </message>
    <message>
        <source>The view cannot draw the camera&apos;s distortion. If your pixels are of the undistorted image, tick the box. Else undistort the image first, then tick the box.</source>
        <translation>视图无法绘制相机的畸变。若您的像素取自去畸变后的图像，请勾选该框。否则请先对图像去畸变，再勾选该框。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PasteChoicesForm</name>
    <message>
        <source>−1 to 1: OpenGL</source>
        <translation>−1 到 1：OpenGL</translation>
    </message>
    <message>
        <source>0 to 1: Vulkan, Direct3D, Metal, WebGPU</source>
        <translation>0 到 1：Vulkan、Direct3D、Metal、WebGPU</translation>
    </message>
    <message>
        <source>As read</source>
        <translation>按读取</translation>
    </message>
    <message>
        <source>As read: %1</source>
        <translation>按读取：%1</translation>
    </message>
    <message>
        <source>OpenGL: right, up, back</source>
        <translation>OpenGL：右、上、后</translation>
    </message>
    <message>
        <source>OpenCV: right, down, ahead</source>
        <translation>OpenCV：右、下、前</translation>
    </message>
    <message>
        <source>Direct3D: right, up, ahead</source>
        <translation>Direct3D：右、上、前</translation>
    </message>
    <message>
        <source>Unreal: ahead, right, up</source>
        <translation>Unreal：前、右、上</translation>
    </message>
    <message>
        <source>ROS: ahead, left, up</source>
        <translation>ROS：前、左、上</translation>
    </message>
    <message>
        <source>World to camera</source>
        <translation>世界到相机</translation>
    </message>
    <message>
        <source>Camera to world</source>
        <translation>相机到世界</translation>
    </message>
    <message>
        <source>At 0, 0</source>
        <translation>在 0, 0</translation>
    </message>
    <message>
        <source>At 0.5, 0.5</source>
        <translation>在 0.5, 0.5</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>The image or frame whose camera is read</source>
        <translation>读取其相机的图像或帧</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>图像大小</translation>
    </message>
    <message>
        <source>Width and height of the camera&apos;s image, pixels: 640 x 480</source>
        <translation>相机图像的宽和高，像素：640 x 480</translation>
    </message>
    <message>
        <source>Give the view this size</source>
        <translation>视图也取此大小</translation>
    </message>
    <message>
        <source>Pixels of the view are then the camera&apos;s pixels; View &gt; Fit the Window undoes it</source>
        <translation>这样视图的像素就是相机的像素；“视图 &gt; 充满窗口”可还原</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>近</translation>
    </message>
    <message>
        <source>Distance of the near plane: it maps depths, and hides what is closer</source>
        <translation>近平面的距离：它决定深度的映射，并隐去更近的东西</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>Distance of the far plane: it maps depths, and hides what is farther</source>
        <translation>远平面的距离：它决定深度的映射，并隐去更远的东西</translation>
    </message>
    <message>
        <source>Fa&amp;r:</source>
        <translation>远(&amp;R)：</translation>
    </message>
    <message>
        <source>Axes of the camera</source>
        <translation>相机的坐标轴</translation>
    </message>
    <message>
        <source>The directions of the camera&apos;s x, y and z in its image</source>
        <translation>相机的 x、y、z 在其图像中的方向</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>What the pose turns into what: its direction</source>
        <translation>位姿的方向：由什么变换到什么</translation>
    </message>
    <message>
        <source>Pixel centres</source>
        <translation>像素中心</translation>
    </message>
    <message>
        <source>The coordinates of the first pixel&apos;s centre in the program</source>
        <translation>在该程序中第一个像素中心的坐标</translation>
    </message>
    <message>
        <source>My pixels are of the undistorted image</source>
        <translation>我的像素取自去畸变后的图像</translation>
    </message>
    <message>
        <source>Drop the distortion coefficients: the view has no distortion</source>
        <translation>去掉畸变系数：视图没有畸变</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>矩阵</translation>
    </message>
    <message>
        <source>The role of the only matrix in the text</source>
        <translation>文本中唯一矩阵的含义</translation>
    </message>
    <message>
        <source>NDC depths</source>
        <translation>NDC 深度</translation>
    </message>
    <message>
        <source>The depths of NDC at near and far</source>
        <translation>近处和远处的 NDC 深度</translation>
    </message>
    <message>
        <source>&amp;Image:</source>
        <translation>图像(&amp;I)：</translation>
    </message>
    <message>
        <source>Image &amp;size:</source>
        <translation>图像大小(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;Near:</source>
        <translation>近(&amp;N)：</translation>
    </message>
    <message>
        <source>&amp;Axes:</source>
        <translation>坐标轴(&amp;A)：</translation>
    </message>
    <message>
        <source>P&amp;ose:</source>
        <translation>位姿(&amp;O)：</translation>
    </message>
    <message>
        <source>Pixel &amp;centres:</source>
        <translation>像素中心(&amp;C)：</translation>
    </message>
    <message>
        <source>&amp;Matrix:</source>
        <translation>矩阵(&amp;M)：</translation>
    </message>
    <message>
        <source>NDC &amp;depths:</source>
        <translation>NDC 深度(&amp;D)：</translation>
    </message>
    <message>
        <source>“%1” is not a distance: type a number greater than 0.</source>
        <translation>“%1”不是距离：请键入大于 0 的数。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PasteReport</name>
    <message>
        <source>Not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>“Pixel centres”</source>
        <translation>“像素中心”</translation>
    </message>
    <message>
        <source>“Image”</source>
        <translation>“图像”</translation>
    </message>
    <message>
        <source>“Image size”</source>
        <translation>“图像大小”</translation>
    </message>
    <message>
        <source>“Near”</source>
        <translation>“近”</translation>
    </message>
    <message>
        <source>“Far”</source>
        <translation>“远”</translation>
    </message>
    <message>
        <source>“Axes”</source>
        <translation>“坐标轴”</translation>
    </message>
    <message>
        <source>“Pose”</source>
        <translation>“位姿”</translation>
    </message>
    <message>
        <source>“My pixels are of the undistorted image”</source>
        <translation>“我的像素取自去畸变后的图像”</translation>
    </message>
    <message>
        <source>“%1”</source>
        <comment>the item of a field</comment>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1，第 %2 行</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a place in a text, what is wrong</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>by columns</source>
        <translation>按列</translation>
    </message>
    <message>
        <source>by rows</source>
        <translation>按行</translation>
    </message>
    <message>
        <source>No name tells what it is: its form does.</source>
        <translation>没有名称说明它是什么：由其形式判定。</translation>
    </message>
    <message>
        <source>Nothing tells its direction. It is read from camera to world, so this is its inverse. The other reading:</source>
        <translation>没有任何内容说明它的方向。它按从相机到世界读取，因此这里是它的逆矩阵。另一种读法：</translation>
    </message>
    <message>
        <source>Nothing tells its direction. It is read from world to camera. The other reading:</source>
        <translation>没有任何内容说明它的方向。它按从世界到相机读取。另一种读法：</translation>
    </message>
    <message>
        <source>It has the form of another matrix, too: choose under “Matrix”.</source>
        <translation>它也符合另一种矩阵的形式：请在“矩阵”处选择。</translation>
    </message>
    <message>
        <source>Not used: %1.</source>
        <translation>未使用：%1。</translation>
    </message>
    <message>
        <source>The viewport is set by glViewport: %1 × %2 at (%3, %4).</source>
        <translation>视口改为 glViewport 的视口：%1 × %2，位于 (%3, %4)。</translation>
    </message>
    <message>
        <source>The viewport, %1 × %2 at (%3, %4), is not used: the view keeps its own.</source>
        <translation>视口 %1 × %2，位于 (%3, %4)，未使用：视图保持自己的视口。</translation>
    </message>
    <message>
        <source>Undo the corrections</source>
        <translation>撤销更正</translation>
    </message>
    <message>
        <source>%1 (line %2)</source>
        <comment>a name in the text</comment>
        <translation>%1（第 %2 行）</translation>
    </message>
    <message>
        <source>, from %1</source>
        <translation>，取自 %1</translation>
    </message>
    <message>
        <source>Camera of %1</source>
        <translation>%1 的相机</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>镜头</translation>
    </message>
    <message>
        <source>fx %1, fy %2, cx %3, cy %4 pixels%5</source>
        <translation>fx %1，fy %2，cx %3，cy %4 像素%5</translation>
    </message>
    <message>
        <source>a projection matrix</source>
        <translation>投影矩阵</translation>
    </message>
    <message>
        <source>Pixel centres</source>
        <translation>像素中心</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>图像大小</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>畸变</translation>
    </message>
    <message>
        <source>Nothing will be seen: no object is in the image.</source>
        <translation>将什么也看不到：图像中没有物体。</translation>
    </message>
    <message>
        <source>Nothing will be seen: the objects are %1 to %2 in front of the eye, not between near and far.</source>
        <translation>将什么也看不到：物体在眼睛前方 %1 至 %2 处，不在近平面和远平面之间。</translation>
    </message>
    <message>
        <source>A part of the objects is in the image.</source>
        <translation>图像中有一部分物体。</translation>
    </message>
    <message>
        <source>The objects are in the image.</source>
        <translation>物体都在图像中。</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>眼睛</translation>
    </message>
    <message>
        <source>Looks along</source>
        <translation>观察方向</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>视场角</translation>
    </message>
    <message>
        <source>%1° high, %2° wide</source>
        <translation>高 %1°，宽 %2°</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>正投影</translation>
    </message>
    <message>
        <source>%1 wide, %2 high</source>
        <translation>宽 %1，高 %2</translation>
    </message>
    <message>
        <source>Near and far</source>
        <translation>近和远</translation>
    </message>
    <message>
        <source>NDC depths</source>
        <translation>NDC 深度</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0 到 1</translation>
    </message>
    <message>
        <source>−1 to 1</source>
        <translation>−1 到 1</translation>
    </message>
    <message>
        <source>The text has no projection: the scene&apos;s projection is kept.</source>
        <translation>文本中没有投影：保留场景的投影。</translation>
    </message>
    <message>
        <source>The text has no view: the scene&apos;s view is kept.</source>
        <translation>文本中没有观察：保留场景的观察。</translation>
    </message>
    <message>
        <source>The view gets the image&apos;s size, %1 × %2.</source>
        <translation>视图取图像的大小，%1 × %2。</translation>
    </message>
    <message>
        <source>The image is larger than %1 pixels: the view keeps its own size.</source>
        <translation>图像大于 %1 像素：视图保持自己的大小。</translation>
    </message>
    <message>
        <source>No camera yet</source>
        <translation>尚无相机</translation>
    </message>
    <message>
        <source>Blender prints this. If it is the camera&apos;s pose, write “matrix_world =” before it, and add the lens in a line below: “lens = 50”.</source>
        <translation>这是 Blender 打印的。如果它是相机的位姿，请在前面写上“matrix_world =”，并在下面一行加上镜头：“lens = 50”。</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <comment>an image, its number, how many there are</comment>
        <translation>%1（第 %2 幅，共 %3 幅）</translation>
    </message>
    <message>
        <source>A camera is that of a program (K, R and t, a camera&apos;s file), matrices of sixteen numbers each, or calls such as gluLookAt.</source>
        <translation>相机可以是某个程序的相机（K、R 和 t，相机文件）、每个十六个数的矩阵，或 gluLookAt 之类的调用。</translation>
    </message>
    <message>
        <source>The view shows the pasted camera at once. Cancel brings the present one back.</source>
        <translation>视图立即显示所粘贴的相机。按“取消”可恢复现在的相机。</translation>
    </message>
    <message>
        <source>Line %1, read %2.</source>
        <translation>第 %1 行，%2读取。</translation>
    </message>
    <message>
        <source>“%1”, line %2, read %3.</source>
        <translation>“%1”，第 %2 行，%3读取。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PickRows</name>
    <message>
        <source>camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>viewport</source>
        <translation>视口</translation>
    </message>
    <message>
        <source>depth range</source>
        <translation>深度范围</translation>
    </message>
    <message>
        <source>window size</source>
        <translation>窗口大小</translation>
    </message>
    <message>
        <source>Setup: the same</source>
        <translation>设置：相同</translation>
    </message>
    <message>
        <source>Setup: other %1</source>
        <translation>设置：不同的有：%1</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>From pick %1 to pick %2</source>
        <translation>从拾取 %1 到拾取 %2</translation>
    </message>
    <message>
        <source>Distance: %1 ± %2</source>
        <translation>距离：%1 ± %2</translation>
    </message>
    <message>
        <source>Δ (x, y, z): %1</source>
        <translation>Δ (x, y, z)：%1</translation>
    </message>
    <message>
        <source>Distance: none, the background has no point</source>
        <translation>距离：无，背景没有点</translation>
    </message>
    <message>
        <source>Depth: %1 (Δ %2)</source>
        <translation>深度：%1（Δ %2）</translation>
    </message>
    <message>
        <source>Pixel: %1 (Δ %2, %3)</source>
        <translation>像素：%1（Δ %2, %3）</translation>
    </message>
    <message>
        <source>Object: %1</source>
        <translation>物体：%1</translation>
    </message>
    <message>
        <source>The object was moved between the two clicks.</source>
        <translation>两次点击之间物体被移动过。</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>拾取</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>World coordinate</source>
        <translation>世界坐标</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>像素</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PickStrip</name>
    <message>
        <source>pixel</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>观察</translation>
    </message>
    <message>
        <source>world</source>
        <translation>世界</translation>
    </message>
    <message>
        <source>object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Click the view: this line then shows the point in every space, from the pixel to the object.</source>
        <translation>单击视图：这一行随后显示该点在每个空间中的坐标，从像素到物体。</translation>
    </message>
    <message>
        <source>The pick in every space</source>
        <translation>拾取点在各空间中的坐标</translation>
    </message>
    <message>
        <source>Device pixel: column and row, counted from the upper left corner</source>
        <translation>设备像素：列和行，从左上角算起</translation>
    </message>
    <message>
        <source>Window point: the pixel&apos;s centre, y upwards, and the depth</source>
        <translation>窗口点：像素中心，y 向上，以及深度</translation>
    </message>
    <message>
        <source>Normalized device coordinates, each from −1 to 1 in the view volume</source>
        <translation>规范化设备坐标，在视景体内各为 −1 到 1</translation>
    </message>
    <message>
        <source>Clip coordinates x, y, z, w: divided by w they are NDC</source>
        <translation>裁剪坐标 x、y、z、w：除以 w 即为 NDC</translation>
    </message>
    <message>
        <source>Eye coordinates: seen from the camera, which looks along −z</source>
        <translation>观察坐标：从沿 −z 观察的相机看去</translation>
    </message>
    <message>
        <source>World coordinates: the answer of the click</source>
        <translation>世界坐标：单击的答案</translation>
    </message>
    <message>
        <source>Object coordinates, as in the file of the clicked object</source>
        <translation>被单击物体的坐标，与其文件中一致</translation>
    </message>
    <message>
        <source>A click shows its matrix.</source>
        <translation>单击可显示其矩阵。</translation>
    </message>
    <message>
        <source>at the
click:</source>
        <translation>点击
时：</translation>
    </message>
    <message>
        <source>The view has changed since: this line has the values at the click</source>
        <translation>点击之后视图已改变：这一行是点击时的数值</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PictureNote</name>
    <message>
        <source>All objects are hidden. The Objects panel shows them again.</source>
        <translation>所有物体均已隐藏。可在“物体”面板中重新显示。</translation>
    </message>
    <message>
        <source>Nothing lies between near, %1, and far, %2: the objects begin at %3 and end at %4.</source>
        <translation>近平面 %1 与远平面 %2 之间没有任何内容：物体从 %3 开始，到 %4 结束。</translation>
    </message>
    <message>
        <source>Far is %1 times near: the depth buffer is too coarse for it, and surfaces look like background. Increase near.</source>
        <translation>远平面距离是近平面的 %1 倍：深度缓冲区无法容纳，表面被当作背景。请增大近平面距离。</translation>
    </message>
    <message>
        <source>Reason for the empty view</source>
        <translation>为何看不到任何内容</translation>
    </message>
    <message>
        <source>The viewport (x %1, y %2, width %3, height %4) lies wholly outside the window, which is %5 × %6 pixels: nothing is drawn. Change x or y, or Reset it.</source>
        <translation>视口（x %1，y %2，宽 %3，高 %4）完全位于窗口之外，窗口为 %5 × %6 像素：什么也不会绘制。请修改 x 或 y，或将其重置。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PipelineChain</name>
    <message>
        <source>Open all</source>
        <translation>全部展开</translation>
    </message>
    <message>
        <source>Show all matrices one below the other</source>
        <translation>依次向下显示全部矩阵</translation>
    </message>
    <message>
        <source>Step to %1</source>
        <translation>到%1的一步</translation>
    </message>
    <message>
        <source>The path starts here</source>
        <translation>路径从这里开始</translation>
    </message>
    <message>
        <source>Show the matrix: %1</source>
        <translation>显示矩阵：%1</translation>
    </message>
    <message>
        <source>Show how %1 follows from the point above</source>
        <translation>显示%1如何由上一行的点得出</translation>
    </message>
    <message>
        <source>Point in %1 coordinates</source>
        <translation>%1坐标中的点</translation>
    </message>
    <message>
        <source>Product %1</source>
        <translation>乘积 %1</translation>
    </message>
    <message>
        <source>Shown below</source>
        <translation>已在下方显示</translation>
    </message>
    <message>
        <source>Not shown</source>
        <translation>未显示</translation>
    </message>
    <message>
        <source>Scroll the points sideways</source>
        <translation>左右滚动各点</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PipelineFeature</name>
    <message>
        <source>Pipeline</source>
        <translation>渲染管线</translation>
    </message>
    <message>
        <source>Every number and every matrix between an object and its pixel</source>
        <translation>从物体到像素之间的每个数和每个矩阵</translation>
    </message>
    <message>
        <source>Viewport</source>
        <translation>视口</translation>
    </message>
    <message>
        <source>Life of the View</source>
        <translation>视图生命周期</translation>
    </message>
    <message>
        <source>Depth Precision</source>
        <translation>深度精度</translation>
    </message>
    <message>
        <source>Paste Ca&amp;mera…</source>
        <translation>粘贴相机(&amp;M)…</translation>
    </message>
    <message>
        <source>Set the camera from another program&apos;s: its matrices, K, R, t, its calls, or its camera&apos;s file</source>
        <translation>取用其他程序的相机：其矩阵，K、R、t，调用或相机文件</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PipelineModel</name>
    <message>
        <source>Background: no surface here, so there is no point to follow.</source>
        <translation>背景：此处没有表面，没有可跟踪的点。</translation>
    </message>
    <message>
        <source>z of NDC from 0 to 1</source>
        <translation>NDC 的 z 从 0 到 1</translation>
    </message>
    <message>
        <source>z of NDC from −1 to 1</source>
        <translation>NDC 的 z 从 −1 到 1</translation>
    </message>
    <message>
        <source>reversed: the depth range is reversed to match</source>
        <translation>反向：为此把深度范围倒过来</translation>
    </message>
    <message>
        <source>the far plane at infinity: here at a million times near</source>
        <translation>远平面在无穷远：这里取近平面的一百万倍</translation>
    </message>
    <message>
        <source>Remove Your Point</source>
        <translation>移除您的点</translation>
    </message>
    <message>
        <source>A widget position has no depth. Type the window point instead: its third number is the depth.</source>
        <translation>控件坐标不含深度。请给出窗口点，其第三个数就是深度。</translation>
    </message>
    <message>
        <source>Give a Point in %1 Coordinates</source>
        <translation>给出%1坐标中的点</translation>
    </message>
    <message>
        <source>Your point was given in the space of “%1”, which does not exist: it is read as a world point.</source>
        <translation>您的点是在“%1”的空间中给出的，而该物体不在此处：按世界坐标处理。</translation>
    </message>
    <message>
        <source>Conventions of %1</source>
        <translation>采用 %1 的约定</translation>
    </message>
    <message>
        <source>Here clip, NDC and depth stay OpenGL&apos;s; the view&apos;s matrix is [R t].</source>
        <translation>此处裁剪坐标、NDC 和深度仍为 OpenGL 的；观察矩阵为 [R t]。</translation>
    </message>
    <message>
        <source>Without a perspective there is no camera matrix K.</source>
        <translation>非透视投影没有相机内参矩阵 K。</translation>
    </message>
    <message>
        <source>The matrix as given: %1. Clip and NDC use its conversion, which follows: OpenGL&apos;s matrix of the same view volume.</source>
        <translation>原样保留：%1。裁剪坐标和 NDC 属于它的转换结果，即同一视景体的 OpenGL 矩阵，列于其后。</translation>
    </message>
    <message>
        <source>Click the model, or type a point into any row.</source>
        <translation>请点击模型，或在任意一行输入一个点。</translation>
    </message>
    <message>
        <source>Backward from the clicked pixel&apos;s centre and its depth.</source>
        <translation>由所点像素的中心及其深度逆向计算。</translation>
    </message>
    <message>
        <source>The view has changed since this click. Values below use the current view.</source>
        <translation>此次点击之后视图已改变。下面的数值使用当前视图。</translation>
    </message>
    <message>
        <source>Forward from the clicked point.</source>
        <translation>由点击的点正向计算。</translation>
    </message>
    <message>
        <source>Your point in %1 coordinates is outside the view volume: %2.</source>
        <translation>您的点（%1坐标）在视景体之外：%2。</translation>
    </message>
    <message>
        <source>Your point in %1 coordinates. Every other stage is computed from it.</source>
        <translation>您的点，%1坐标。其他各级都由它算出。</translation>
    </message>
    <message>
        <source>These are the values at the click. To give a point, choose “Now” first.</source>
        <translation>这些是点击时的数值。要给出一点，请先选择“现在”。</translation>
    </message>
    <message>
        <source>Values at the click: forward from the clicked point.</source>
        <translation>点击时的数值：由点击的点正向计算。</translation>
    </message>
    <message>
        <source>Values at the click: backward from the pixel&apos;s centre and its depth.</source>
        <translation>点击时的数值：由像素的中心及其深度逆向计算。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PipelinePanel</name>
    <message>
        <source>↓  divide by w</source>
        <translation>↓  透视除法：除以 w</translation>
    </message>
    <message>
        <source>↓  divide by its own w′, as gluUnProject does</source>
        <translation>↓  除以它自己的 w′，与 gluUnProject 相同</translation>
    </message>
    <message>
        <source>Forward shows the factors; this matrix is the inverse of their product.</source>
        <translation>选“正向”可看各因子；此矩阵是它们乘积的逆矩阵。</translation>
    </message>
    <message>
        <source>Differences from OpenGL</source>
        <translation>与 OpenGL 的不同之处</translation>
    </message>
    <message>
        <source>%1 as given</source>
        <translation>%1，原样保留</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PipelineSwitches</name>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>From the object to the widget</source>
        <translation>从物体到控件</translation>
    </message>
    <message>
        <source>Backward</source>
        <translation>逆向</translation>
    </message>
    <message>
        <source>From the window to the object, by the inverse of each matrix</source>
        <translation>从窗口到物体，用各矩阵的逆矩阵</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>向量</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列向量</translation>
    </message>
    <message>
        <source>Column vectors, M · v, as OpenGL writes them</source>
        <translation>列向量，M · v，OpenGL 的写法</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行向量</translation>
    </message>
    <message>
        <source>Row vectors, v · M: every matrix transposed, products in reversed order</source>
        <translation>行向量，v · M：每个矩阵都转置，乘积次序相反</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>排列</translation>
    </message>
    <message>
        <source>4 × 4</source>
        <translation>4 × 4</translation>
    </message>
    <message>
        <source>Rows and columns, as matrices are printed</source>
        <translation>行和列，矩阵的印刷形式</translation>
    </message>
    <message>
        <source>The memory order that glGetFloatv gives and a debugger shows, the same for column and row vectors</source>
        <translation>glGetFloatv 给出、调试器显示的内存次序，对列向量和行向量都相同</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>数位</translation>
    </message>
    <message>
        <source>Nine digits of the double; all of them in the tooltip and when copied</source>
        <translation>显示双精度的九位数字；提示和复制中有全部数字</translation>
    </message>
    <message>
        <source>All digits</source>
        <translation>全部位数</translation>
    </message>
    <message>
        <source>All digits of the double, up to 17; needs more space</source>
        <translation>双精度的全部数字，最多 17 位；需要较宽的位置</translation>
    </message>
    <message>
        <source>Rounded to single precision, with all its digits</source>
        <translation>舍入到单精度，显示其全部数位</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>&amp;Object:</source>
        <translation>物体(&amp;O)：</translation>
    </message>
    <message>
        <source>Conventions</source>
        <translation>约定</translation>
    </message>
    <message>
        <source>&amp;Copy all</source>
        <translation>全部复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy all points and matrices with all digits</source>
        <translation>复制带全部数位的所有点和矩阵</translation>
    </message>
    <message>
        <source>P&amp;aste…</source>
        <translation>粘贴(&amp;A)…</translation>
    </message>
    <message>
        <source>None (identity)</source>
        <translation>无（单位矩阵）</translation>
    </message>
    <message>
        <source>The object whose space comes first in the chain</source>
        <translation>变换链从该物体的坐标开始</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Format (%1)</source>
        <translation>格式（%1）</translation>
    </message>
    <message>
        <source>Format of vectors, matrices and digits, and the conventions. Now: %1</source>
        <translation>向量、矩阵和数位的写法，以及按哪种 API 的约定。当前：%1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Clicked object (%1)</source>
        <translation>点击的物体（%1）</translation>
    </message>
    <message>
        <source>Clicked object</source>
        <translation>点击的物体</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>At click</source>
        <translation>点击时</translation>
    </message>
    <message>
        <source>Points and matrices as they were at the click</source>
        <translation>点击时的各点和矩阵</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>The clicked point in the view as it is now</source>
        <translation>点击的点在现在视图中的坐标</translation>
    </message>
    <message>
        <source>Paste camera</source>
        <translation>粘贴相机</translation>
    </message>
    <message>
        <source>Set the camera from another program&apos;s (Ctrl+V)</source>
        <translation>按其他程序的相机设置相机 (Ctrl+V)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PointModel</name>
    <message>
        <source>object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>world</source>
        <translation>世界</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>观察</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>widget</source>
        <translation>控件</translation>
    </message>
    <message>
        <source>%1 = %2
in the object&apos;s own units</source>
        <translation>%1 = %2
物体坐标（模型坐标，MC），物体自身的单位</translation>
    </message>
    <message>
        <source>%1 = %2
in world units</source>
        <translation>%1 = %2
世界单位</translation>
    </message>
    <message>
        <source>z = %1
in world units; the eye looks along −z</source>
        <translation>z = %1
世界单位；视点朝 −z 方向看</translation>
    </message>
    <message>
        <source>%1 = %2
in world units, from the eye</source>
        <translation>%1 = %2
世界单位，从视点算起</translation>
    </message>
    <message>
        <source>w = %1
what x, y and z are divided by</source>
        <translation>w = %1
透视除法中 x、y、z 要除以的数</translation>
    </message>
    <message>
        <source>%1 = %2
homogeneous; inside the view volume from −w to w</source>
        <translation>%1 = %2
齐次坐标；视景体内从 −w 到 w</translation>
    </message>
    <message>
        <source>%1 = %2
inside the view volume from −1 to 1</source>
        <translation>%1 = %2
规范化设备坐标 (NDC)，视景体内从 −1 到 1</translation>
    </message>
    <message>
        <source>depth = %1
in the depth range</source>
        <translation>深度 = %1
在深度范围内</translation>
    </message>
    <message>
        <source>%1 = %2
in device pixels from the bottom-left corner, y up</source>
        <translation>%1 = %2
设备像素，原点在左下角，y 向上</translation>
    </message>
    <message>
        <source>%1 = %2
in logical pixels from the top-left corner, y down</source>
        <translation>%1 = %2
控件坐标（Windows 屏幕坐标），逻辑像素，原点在左上角，y 向下</translation>
    </message>
    <message>
        <source>eye · w′</source>
        <translation>观察 · w′</translation>
    </message>
    <message>
        <source>%1 = %2
what x′, y′ and z′ are divided by</source>
        <translation>%1 = %2
x′、y′、z′ 要除以的数</translation>
    </message>
    <message>
        <source>%1 = %2
of the eye point before the division by its own w′</source>
        <translation>%1 = %2
除以自己的 w′ 之前的观察坐标</translation>
    </message>
    <message>
        <source>w = %1
of a point that needs no division</source>
        <translation>w = %1
不需要再做除法的点的第四分量</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::Points</name>
    <message>
        <source>free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>顶点 %1</translation>
    </message>
    <message>
        <source>edge %1–%2</source>
        <translation>边 %1–%2</translation>
    </message>
    <message>
        <source>Free: only its coordinates define the position.</source>
        <translation>不依附于任何东西：位置由坐标给出。</translation>
    </message>
    <message>
        <source>On triangle %1 of the mesh, by barycentric coordinates %2, %3, %4.</source>
        <translation>在网格的三角形 %1 上，重心坐标为 %2、%3、%4。</translation>
    </message>
    <message>
        <source>At vertex %1 of the mesh, with its exact coordinate.</source>
        <translation>在网格的顶点 %1，即其坐标本身。</translation>
    </message>
    <message>
        <source>On the edge from vertex %1 to vertex %2 of the mesh, %3 of the way.</source>
        <translation>在网格从顶点 %1 到顶点 %2 的边上，处于全程的 %3。</translation>
    </message>
    <message>
        <source>there are fewer than two landmarks</source>
        <translation>少于两个标志点</translation>
    </message>
    <message>
        <source>two landmarks coincide, so there is no direction</source>
        <translation>两个标志点在同一处，因此没有方向</translation>
    </message>
    <message>
        <source>within their uncertainty the three landmarks lie on one line, so there is no plane</source>
        <translation>在其确定程度内，这三个标志点在一条直线上，因此没有平面</translation>
    </message>
    <message>
        <source>not placed</source>
        <comment>state of a landmark</comment>
        <translation>未放置</translation>
    </message>
    <message>
        <source>skipped</source>
        <comment>state of a landmark</comment>
        <translation>已跳过</translation>
    </message>
    <message>
        <source>missing</source>
        <comment>state of a landmark</comment>
        <translation>缺失</translation>
    </message>
    <message>
        <source>Missing on this specimen. To place it all the same, click this row, then the surface.</source>
        <translation>此标本上没有这个点。若仍要放置它，请点击这一行，再点击表面。</translation>
    </message>
    <message>
        <source>Skipped: it comes again after the others.</source>
        <translation>已跳过：在其他标志点之后再次轮到它。</translation>
    </message>
    <message>
        <source>Not placed yet.</source>
        <translation>尚未放置。</translation>
    </message>
    <message>
        <source>%1 is missing on this specimen</source>
        <translation>此标本上没有 %1</translation>
    </message>
    <message>
        <source>%1 is not placed yet</source>
        <translation>%1 尚未放置</translation>
    </message>
    <message>
        <source>Its pixel held an edge of the surface: beside it was the background.</source>
        <translation>它的像素内曾有表面的边缘：旁边是背景。</translation>
    </message>
    <message>
        <source>Its pixel held an edge of the surface: %1 behind it lay %2. The ± reaches there.</source>
        <translation>它的像素内曾有表面的边缘：其后 %1 处是 %2。± 包括到那里。</translation>
    </message>
    <message>
        <source>Its pixel held an edge of the surface: %1 before it lay %2. The ± reaches there.</source>
        <translation>它的像素内曾有表面的边缘：其前 %1 处是 %2。± 包括到那里。</translation>
    </message>
    <message>
        <source>a landmark has no position</source>
        <translation>有一个标志点没有位置</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>颜色(&amp;C)：</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Light or dark windows</source>
        <translation>浅色或深色窗口</translation>
    </message>
    <message>
        <source>The language of the program, from its next start on</source>
        <translation>程序的语言，下次启动时生效</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>语言 Language(&amp;L)：</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>The new language is used from the next start on.</source>
        <translation>更改的语言在下次启动时生效。</translation>
    </message>
    <message>
        <source>3-D view:</source>
        <translation>三维视图：</translation>
    </message>
    <message>
        <source>Show First &amp;Steps Again</source>
        <translation>再次显示入门(&amp;S)</translation>
    </message>
    <message>
        <source>Show the three things to try, now and at the next start</source>
        <translation>现在以及下次启动时显示可以尝试的三件事</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>Restore the default layout of all workspaces</source>
        <translation>把所有工作区的面板放回最初的位置</translation>
    </message>
    <message>
        <source>Start over:</source>
        <translation>恢复：</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::Program</name>
    <message>
        <source>The system cannot start %1 more threads. Close other programs, then try again.</source>
        <translation>系统无法再启动 %1 个线程。请关闭其他程序后重试。</translation>
    </message>
    <message>
        <source>There is no display. Set DISPLAY, or run under xvfb-run.</source>
        <translation>没有可用的显示。请设置 DISPLAY，或在 xvfb-run 下运行。</translation>
    </message>
    <message>
        <source>No window can be opened (%1). Set DISPLAY to a display that answers, or run under xvfb-run.</source>
        <translation>无法打开窗口（%1）。请将 DISPLAY 设为可以连接的显示，或在 xvfb-run 下运行。</translation>
    </message>
    <message>
        <source>Standard output cannot be written: %1.</source>
        <translation>无法写入标准输出：%1。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ProjectionGroup</name>
    <message>
        <source>Kind of projection</source>
        <translation>投影的种类</translation>
    </message>
    <message>
        <source>Frustum (glFrustum)</source>
        <translation>透视投影 (glFrustum)</translation>
    </message>
    <message>
        <source>Perspective (gluPerspective)</source>
        <translation>透视投影 (gluPerspective)</translation>
    </message>
    <message>
        <source>Orthographic (glOrtho)</source>
        <translation>正投影 (glOrtho)</translation>
    </message>
    <message>
        <source>Oblique (glOrtho, sheared)</source>
        <translation>斜投影（glOrtho，错切）</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>视场角</translation>
    </message>
    <message>
        <source>Vertical angle of view in degrees, between 0 and 180 (gluPerspective: fovy)</source>
        <translation>垂直视场角，以度计，在 0 与 180 之间 (gluPerspective: fovy)</translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation>宽高比</translation>
    </message>
    <message>
        <source>Width divided by height of the view (gluPerspective: aspect)</source>
        <translation>画面的宽除以高 (gluPerspective: aspect)</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Left edge of the view volume, eye units; of a frustum on its near plane</source>
        <translation>视景体的左边界，观察坐标单位；对透视投影，取在近平面上</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Right edge of the view volume, eye units; of a frustum on its near plane</source>
        <translation>视景体的右边界，观察坐标单位；对透视投影，取在近平面上</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Lower edge of the view volume, eye units; of a frustum on its near plane</source>
        <translation>视景体的下边界，观察坐标单位；对透视投影，取在近平面上</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Upper edge of the view volume, eye units; of a frustum on its near plane</source>
        <translation>视景体的上边界，观察坐标单位；对透视投影，取在近平面上</translation>
    </message>
    <message>
        <source>Skew</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>Shift of x per unit of y in eye space before glFrustum, as by the skew of a camera matrix</source>
        <translation>在 glFrustum 之前，观察空间中每单位 y 使 x 移动的距离，如相机矩阵的倾斜</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>近</translation>
    </message>
    <message>
        <source>Distance of the near plane in front of the eye, eye units; smaller than far, and above 0 in a perspective</source>
        <translation>近平面在视点前方的距离，观察坐标单位；小于远平面距离，透视投影中须大于 0</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>Distance of the far plane in front of the eye, eye units; greater than near</source>
        <translation>远平面在视点前方的距离，观察坐标单位；大于近平面距离</translation>
    </message>
    <message>
        <source>θ</source>
        <translation>θ</translation>
    </message>
    <message>
        <source>φ</source>
        <translation>φ</translation>
    </message>
    <message>
        <source>Compute the width from the height and the viewport&apos;s aspect, so that a circle stays a circle. Typing left, right or the aspect switches this off</source>
        <translation>宽度始终取与高度相应的视口比例，使圆仍是圆。输入左、右或宽高比会关闭此项</translation>
    </message>
    <message>
        <source>Fit near and far to the objects</source>
        <translation>近、远平面适合物体</translation>
    </message>
    <message>
        <source>Set near and far tightly around the objects, for the most accurate depth. Typing one of them switches this off</source>
        <translation>近、远平面紧贴物体，使深度尽可能精确。输入其中之一会关闭此项</translation>
    </message>
    <message>
        <source>Aspect follows the viewport</source>
        <translation>宽高比跟随视口</translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation>保持比例</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>glFrustum, gluPerspective, glOrtho, oblique</source>
        <translation>glFrustum、gluPerspective、glOrtho、斜投影</translation>
    </message>
    <message>
        <source>A perspective of 45°, the viewport&apos;s aspect, near and far around the objects</source>
        <translation>45° 的透视投影，宽高比随视口，近、远平面包围物体</translation>
    </message>
    <message>
        <source>Switching the kind keeps the view as similar as possible: objects at the center&apos;s distance keep their position and size</source>
        <translation>换一种投影时画面尽可能相同：位于观察中心距离处的内容保持位置和大小</translation>
    </message>
    <message>
        <source>Angle of the shear in x, degrees, more than 0 and less than 180: x grows by cot θ · z. 45 moves a point as far to the side as it lies deep, 90 is no shear</source>
        <translation>x 方向的剪切角，度，大于 0 且小于 180：x 增加 cot θ · z。45 使点的横移等于其深度，90 为无剪切</translation>
    </message>
    <message>
        <source>Angle of the shear in y, degrees, more than 0 and less than 180: y grows by cot φ · z. 45 moves a point as far down as it lies deep, 90 is no shear</source>
        <translation>y 方向的剪切角，度，大于 0 且小于 180：y 增加 cot φ · z。45 使点的下移等于其深度，90 为无剪切</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::Protocol</name>
    <message>
        <source>distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>along the surface</source>
        <translation>沿曲面</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>kind of a measure, its landmarks</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>click to compute</source>
        <translation>点击以计算</translation>
    </message>
    <message>
        <source>computed at export</source>
        <translation>在导出时计算</translation>
    </message>
    <message>
        <source>%1. The tables of Export have its value.</source>
        <comment>a measure along the surface</comment>
        <translation>%1。导出的表格中有它的值。</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>a measure, its value</comment>
        <translation>%1。%2</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::RayModel</name>
    <message>
        <source>Vertex</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>On edge</source>
        <translation>边上</translation>
    </message>
    <message>
        <source>On face</source>
        <translation>面上</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>Where the ray through the pixel&apos;s centre meets the mesh itself, in double, without the depth buffer; world units</source>
        <translation>经过像素中心的射线与网格本身的交点，双精度，不经过深度缓冲；世界单位</translation>
    </message>
    <message>
        <source>The normal of the triangle, of length 1, world space</source>
        <translation>三角形的法线，长度为 1，世界空间</translation>
    </message>
    <message>
        <source>The nearest corner of the triangle; world units</source>
        <translation>三角形最近的顶点；世界单位</translation>
    </message>
    <message>
        <source>The vertex that the click takes; world units</source>
        <translation>点击所取的顶点；世界单位</translation>
    </message>
    <message>
        <source>The point of an edge that the click takes; world units</source>
        <translation>点击所取的边上的点；世界单位</translation>
    </message>
    <message>
        <source>The point of the face that the click takes; world units</source>
        <translation>点击所取的面上的点；世界单位</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>Exact hit</source>
        <translation>精确交点</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ReadingWindow</name>
    <message>
        <source>Page</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>A−</source>
        <translation>A−</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>缩小文字</translation>
    </message>
    <message>
        <source>Text in its usual size</source>
        <translation>文字恢复通常大小</translation>
    </message>
    <message>
        <source>A+</source>
        <translation>A+</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>放大文字</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Find words in the page</source>
        <translation>在页面中查找文字</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::RecoveryBar</name>
    <message>
        <source>Unsaved changes of an earlier session</source>
        <translation>先前未保存的更改</translation>
    </message>
    <message>
        <source>Kept scene</source>
        <translation>保留的场景</translation>
    </message>
    <message>
        <source>The kept scenes, the last one first</source>
        <translation>保留的场景，最近的在最前</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>恢复(&amp;R)</translation>
    </message>
    <message>
        <source>Open the scene with these changes; its file stays as it is until you save</source>
        <translation>打开带有这些更改的场景；在您保存之前，原文件保持不变</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>丢弃(&amp;D)</translation>
    </message>
    <message>
        <source>Delete these changes for good</source>
        <translation>永久删除这些更改</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>以后再说(&amp;L)</translation>
    </message>
    <message>
        <source>Keep the changes and ask again at the next start</source>
        <translation>保留这些更改，下次启动时再询问</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>The program ended unexpectedly on %1. The unsaved changes to %2 were kept.</source>
        <translation>程序于 %1 意外退出。对 %2 的未保存更改已保留。</translation>
    </message>
    <message numerus="yes">
        <source>The program ended unexpectedly. The unsaved changes to %n scenes were kept:</source>
        <translation>
            <numerusform>程序意外退出。对 %n 个场景的未保存更改已保留：</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>unprojector::gui::RecoveryTexts</name>
    <message>
        <source>%1 (landmarks placed: %2; in its file: %3)</source>
        <translation>%1（已放置标志点：%2；其文件中：%3）</translation>
    </message>
    <message>
        <source>%1 of the series “%2”</source>
        <translation>系列“%2”的 %1</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::RepeatsDialog</name>
    <message>
        <source>Repeats: Error of Measurement</source>
        <translation>重复测量：测量误差</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>标志点</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Placings</source>
        <translation>遍次</translation>
    </message>
    <message>
        <source>Error ±</source>
        <translation>误差 ±</translation>
    </message>
    <message>
        <source>ICC(1)</source>
        <translation>ICC(1)</translation>
    </message>
    <message>
        <source>ICC(2,1)</source>
        <translation>ICC(2,1)</translation>
    </message>
    <message>
        <source>Error of %1</source>
        <translation>遍次 %1 的误差</translation>
    </message>
    <message>
        <source>Bias of %1</source>
        <translation>遍次 %1 的偏差</translation>
    </message>
    <message>
        <source>Error of measurement of each landmark</source>
        <translation>每个标志点的测量误差</translation>
    </message>
    <message>
        <source>Scans on which the landmark was placed more than once</source>
        <translation>该标志点放置过不止一遍的扫描</translation>
    </message>
    <message>
        <source>All placings on these scans</source>
        <translation>这些扫描上的所有遍次</translation>
    </message>
    <message>
        <source>Standard deviation of one placing, pooled over the scans: the technical error of measurement; for two placings Dahlberg&apos;s error</source>
        <translation>单个遍次的标准差，对各扫描合并：即技术测量误差；两个遍次时为 Dahlberg 误差</translation>
    </message>
    <message>
        <source>Intraclass correlation of one placing: the share of the variance that is between scans, after Procrustes superimposition</source>
        <translation>单个遍次的组内相关系数：普氏叠合之后，方差中扫描之间所占的份额</translation>
    </message>
    <message>
        <source>The same for scans with all placings, each by another observer; the observers&apos; differences count as error</source>
        <translation>同上，取具有所有遍次的扫描，每个遍次由另一位观察者完成；观察者之间的差别算作误差</translation>
    </message>
    <message>
        <source>Standard deviation of this placing; of two placings, both have the same</source>
        <translation>该遍次的标准差；只有两个遍次时，二者相同</translation>
    </message>
    <message>
        <source>Distance of this placing&apos;s mean from the mean of all placings</source>
        <translation>该遍次的平均值与所有遍次平均值的距离</translation>
    </message>
    <message>
        <source>All landmarks</source>
        <translation>所有标志点</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Export &amp;Means…</source>
        <translation>导出平均值(&amp;M)…</translation>
    </message>
    <message>
        <source>Copy the table to the clipboard</source>
        <translation>把表格复制到剪贴板</translation>
    </message>
    <message>
        <source>Write this table to a file, with all digits</source>
        <translation>把这张表格写入文件，保留全部位数</translation>
    </message>
    <message>
        <source>Write the mean and the scatter of each landmark on each scan to a file</source>
        <translation>把每个扫描上每个标志点的平均值和离散程度写入文件</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SaveName</name>
    <message>
        <source>%1: no format has this suffix. End the name with one of: %2.</source>
        <translation>%1：没有格式使用此后缀。名称请以其中之一结尾：%2。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ScanSeries</name>
    <message>
        <source>%1: this folder has no model file. Supported: %2.</source>
        <translation>%1：此文件夹中没有模型文件。可读取：%2。</translation>
    </message>
    <message>
        <source>The file is not overwritten: to keep new landmarks, save the scene. Or repair or move the file, and open the scan again.</source>
        <translation>该文件不会被覆盖：现在放置的点只有保存场景才能保留。请修好该文件或把它移走，然后重新打开这个扫描。</translation>
    </message>
    <message>
        <source>Placing %1 continues. Repair the file, or move it away.</source>
        <translation>仍继续第 %1 遍。请修好该文件，或把它移走。</translation>
    </message>
    <message>
        <source>%1: this file has the landmarks of %2 specimens. A scan is one specimen: put each into its own file.</source>
        <translation>%1：这里有 %2 个标本的标志点；一个扫描是一个标本，请把每个标本放进各自的文件。</translation>
    </message>
    <message>
        <source>The series takes its %1 names from %2.</source>
        <translation>系列的 %1 个名称取自 %2。</translation>
    </message>
    <message>
        <source>%1 of %2, %3 missing</source>
        <translation>%1 / %2，缺失 %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Redone on %1: %2.</source>
        <translation>已在 %1 上重做：%2。</translation>
    </message>
    <message>
        <source>Undone on %1: %2.</source>
        <translation>已在 %1 上撤销：%2。</translation>
    </message>
    <message>
        <source>The landmarks of %1 are saved in %2 already.</source>
        <translation>%1 的标志点已经保存在 %2 中。</translation>
    </message>
    <message>
        <source>%1 has no landmark yet, so there is nothing to save.</source>
        <translation>%1 还没有标志点，无需保存。</translation>
    </message>
    <message>
        <source>The landmarks of %1 are saved. Other changes of the scene are not: choose File &gt; Save Scene As to save them.</source>
        <translation>%1 的标志点已保存。场景的其他更改尚未保存：要保存它们，请选择“文件 &gt; 场景另存为”。</translation>
    </message>
    <message>
        <source>The series cannot continue at %1. Its landmarks are shown as a scene: export them to keep them.</source>
        <translation>系列无法从 %1 继续。它的标志点作为场景显示：要保留它们，请导出。</translation>
    </message>
    <message>
        <source>The series continues at %1.</source>
        <translation>系列从 %1 继续。</translation>
    </message>
    <message>
        <source>The series continues at %1. Its landmarks were saved in %2.</source>
        <translation>系列从 %1 继续。它的标志点已保存在 %2 中。</translation>
    </message>
    <message>
        <source>%1 has changed since the landmarks were recovered from the crash: placed in the file: %2; recovered: %3. The file is not overwritten; move it away to keep the recovered ones.</source>
        <translation>崩溃之后 %1 已改变：文件中已放置：%2；已恢复：%3。该文件不会被覆盖；要保存所恢复的标志点，请先把该文件移走。</translation>
    </message>
    <message>
        <source>Names and hints of the series are not kept. Repair the file or move it away.</source>
        <translation>系列的名称和提示不会保存。请修复该文件或把它移走。</translation>
    </message>
    <message>
        <source>Press Ctrl+PgDown for the next scan.</source>
        <translation>请按 Ctrl+PgDown 转到下一个扫描。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SceneCodeWindow</name>
    <message>
        <source>Scene as Code</source>
        <translation>场景代码</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>库</translation>
    </message>
    <message>
        <source>GLU and MFC</source>
        <translation>GLU 和 MFC</translation>
    </message>
    <message>
        <source>OpenGL&apos;s own calls and GLU&apos;s, with the paper&apos;s handlers for a view of MFC</source>
        <translation>OpenGL 与 GLU 的调用，附论文中 MFC 视图类的各个处理函数</translation>
    </message>
    <message>
        <source>C++ with GLM, in double precision</source>
        <translation>C++ 与 GLM，双精度</translation>
    </message>
    <message>
        <source>C++ with QMatrix4x4, in single precision</source>
        <translation>C++ 与 QMatrix4x4，单精度</translation>
    </message>
    <message>
        <source>JavaScript with three.js</source>
        <translation>JavaScript 与 three.js</translation>
    </message>
    <message>
        <source>The scene&apos;s code</source>
        <translation>场景的代码</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy all of the code</source>
        <translation>把全部代码放到剪贴板</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Write the code to a file</source>
        <translation>把代码写入文件</translation>
    </message>
    <message>
        <source>Save Code</source>
        <translation>保存代码</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Python with NumPy alone: the matrices, and a click by formula and by inverse</source>
        <translation>只用 NumPy 的 Python：各矩阵，以及用公式和逆矩阵算出的点击</translation>
    </message>
    <message>
        <source>JavaScript (%1)</source>
        <translation>JavaScript (%1)</translation>
    </message>
    <message>
        <source>Python (%1)</source>
        <translation>Python (%1)</translation>
    </message>
    <message>
        <source>C++ (%1)</source>
        <translation>C++ (%1)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SceneCurves</name>
    <message>
        <source>computing its curves was cancelled</source>
        <translation>等待其曲线时被取消</translation>
    </message>
    <message>
        <source>a curve needs at least two landmarks</source>
        <translation>曲线至少要有两个标志点</translation>
    </message>
    <message>
        <source>“%1” is not on a surface; select it and press B</source>
        <translation>“%1”不在曲面上；按 B 可放到曲面上</translation>
    </message>
    <message>
        <source>the surface between “%1” and “%2” is not in one piece</source>
        <translation>“%1”与“%2”之间的曲面不连通</translation>
    </message>
    <message>
        <source>no plane along the surface&apos;s normals leads from “%1” to “%2”; use the geodesic, or place a landmark between them</source>
        <translation>没有沿曲面法线的平面从“%1”通到“%2”；请改用测地线，或在两者之间再放一个标志点</translation>
    </message>
    <message>
        <source>curve %1</source>
        <translation>曲线 %1</translation>
    </message>
    <message>
        <source>“%1” lies on another object than “%2”</source>
        <translation>“%1”与“%2”不在同一物体上</translation>
    </message>
    <message>
        <source>there is no object “%1”</source>
        <translation>没有物体“%1”</translation>
    </message>
    <message>
        <source>there is no landmark “%1”</source>
        <translation>没有标志点“%1”</translation>
    </message>
    <message>
        <source>it can have at most %1 landmarks</source>
        <translation>最多对 %1 个标志点进行计算</translation>
    </message>
    <message>
        <source>several landmarks are called “%1”; rename all but one</source>
        <translation>有多个标志点名为“%1”；请只保留一个，其余改名</translation>
    </message>
    <message>
        <source>%1 has no name; give it one, because curves refer to landmarks by name</source>
        <translation>%1 没有名称；曲线按名称认标志点</translation>
    </message>
    <message>
        <source>Curve %1</source>
        <translation>曲线 %1</translation>
    </message>
    <message>
        <source>Join %1</source>
        <translation>连接 %1</translation>
    </message>
    <message>
        <source>Semilandmarks of %1</source>
        <translation>%1 的半标志点</translation>
    </message>
    <message>
        <source>Kind of %1</source>
        <translation>%1 的路径</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>cancelled; its menu computes it again</source>
        <translation>已取消；可在其菜单中重新计算</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SceneDocument</name>
    <message>
        <source>Add objects</source>
        <translation>添加物体</translation>
    </message>
    <message>
        <source>Remove object</source>
        <translation>移除物体</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>初始视图</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>正投影</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>透视投影</translation>
    </message>
    <message>
        <source>Order of objects</source>
        <translation>物体顺序</translation>
    </message>
    <message>
        <source>Hide object</source>
        <translation>隐藏物体</translation>
    </message>
    <message>
        <source>Show object</source>
        <translation>显示物体</translation>
    </message>
    <message>
        <source>Show all objects</source>
        <translation>显示全部物体</translation>
    </message>
    <message>
        <source>Rename object</source>
        <translation>重命名物体</translation>
    </message>
    <message>
        <source>Add clip plane</source>
        <translation>添加裁剪平面</translation>
    </message>
    <message>
        <source>Flip clip plane</source>
        <translation>翻转裁剪平面</translation>
    </message>
    <message>
        <source>Remove clip plane</source>
        <translation>移除裁剪平面</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SceneFiles</name>
    <message>
        <source>%1: the open scene uses this file and would destroy it. Choose another name.</source>
        <translation>%1：打开的场景正在使用此文件，写入会毁掉它。请另给一个名称。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SceneLandmarks</name>
    <message>
        <source>landmark %1</source>
        <translation>标志点 %1</translation>
    </message>
    <message>
        <source>Landmark %1</source>
        <translation>标志点 %1</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>放置 %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>%1 的备注</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>%1 的颜色</translation>
    </message>
    <message numerus="yes">
        <source>Colour of %n landmarks</source>
        <translation>
            <numerusform>%n 个标志点的颜色</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>隐藏 %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>显示 %1</translation>
    </message>
    <message numerus="yes">
        <source>Hide %n landmarks</source>
        <translation>
            <numerusform>隐藏 %n 个标志点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Show %n landmarks</source>
        <translation>
            <numerusform>显示 %n 个标志点</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n landmarks</source>
        <translation>
            <numerusform>移除 %n 个标志点</numerusform>
        </translation>
    </message>
    <message>
        <source>Order of landmarks</source>
        <translation>标志点的顺序</translation>
    </message>
    <message>
        <source>Put %1 on the surface</source>
        <translation>将 %1 放到表面上</translation>
    </message>
    <message numerus="yes">
        <source>Put %n landmarks on the surface</source>
        <translation>
            <numerusform>将 %n 个标志点放到表面上</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n landmarks</source>
        <translation>
            <numerusform>移动 %n 个标志点</numerusform>
        </translation>
    </message>
    <message>
        <source>Mark %1 as missing</source>
        <translation>将 %1 标为缺失</translation>
    </message>
    <message>
        <source>Mark %1 as not missing</source>
        <translation>去掉 %1 的缺失标记</translation>
    </message>
    <message numerus="yes">
        <source>Mark %n landmarks as missing</source>
        <translation>
            <numerusform>将 %n 个标志点标为缺失</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Mark %n landmarks as not missing</source>
        <translation>
            <numerusform>去掉 %n 个标志点的缺失标记</numerusform>
        </translation>
    </message>
    <message>
        <source>Skip %1</source>
        <translation>跳过 %1</translation>
    </message>
    <message>
        <source>Place %1 again</source>
        <translation>重新放置 %1</translation>
    </message>
    <message numerus="yes">
        <source>Place %n landmarks again</source>
        <translation>
            <numerusform>重新放置 %n 个标志点</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SceneOpener</name>
    <message>
        <source>The files cannot be opened: %1. Close other programs, then try again.</source>
        <translation>无法打开文件：%1。请关闭其他程序，然后重试。</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 及另外 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: unknown key in a transform step; it is not saved.</source>
        <translation>%1：变换步骤中的未知键，不会被保存。</translation>
    </message>
    <message>
        <source>%1: unknown key; it is not saved once the clip plane is switched on.</source>
        <translation>%1：未知键，启用该裁剪平面后不会被保存。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SceneView</name>
    <message>
        <source>3-D view</source>
        <translation>三维视图</translation>
    </message>
    <message>
        <source>Click the model, or press Enter, to read the world coordinate of the pixel under the pointer or the crosshair. Arrow keys turn, with Shift they move, with Ctrl they move the crosshair; plus and minus zoom</source>
        <translation>单击模型，或按回车键，读取指针或十字线处像素的世界坐标。方向键转动，加 Shift 平移，加 Ctrl 移动十字线；加号和减号缩放</translation>
    </message>
    <message>
        <source>The depth of this pixel could not be read: OpenGL reported an error.</source>
        <translation>无法读取该像素的深度：OpenGL 报告了错误。</translation>
    </message>
    <message>
        <source>OpenGL %1.%2 core, depth %3 bits, stencil %4 bits, %5 samples</source>
        <translation>OpenGL %1.%2 核心模式，深度 %3 位，模板 %4 位，%5 个采样</translation>
    </message>
    <message>
        <source>requested: %1; received: %2</source>
        <translation>请求：%1；得到：%2</translation>
    </message>
    <message>
        <source>Pick Here</source>
        <translation>在此拾取</translation>
    </message>
    <message>
        <source>Read the world coordinate of this pixel</source>
        <translation>读取该像素的世界坐标</translation>
    </message>
    <message>
        <source>Look at This Point</source>
        <translation>看向该点</translation>
    </message>
    <message>
        <source>Centre the view on this point and turn about it</source>
        <translation>把它移到中央，视图绕它转动</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Move the camera until all objects fill the view</source>
        <translation>移动相机，使所有物体充满视图</translation>
    </message>
    <message>
        <source>Fit This Object</source>
        <translation>适合该物体</translation>
    </message>
    <message>
        <source>Move the camera so that this object fills the view</source>
        <translation>看向该物体，使其充满视图</translation>
    </message>
    <message>
        <source>Hide This Object</source>
        <translation>隐藏该物体</translation>
    </message>
    <message>
        <source>Hide it from the view and from clicks; the Objects panel shows it again</source>
        <translation>既不绘制也不能点选；可在“物体”面板中重新显示</translation>
    </message>
    <message>
        <source>Show All Objects</source>
        <translation>显示全部物体</translation>
    </message>
    <message>
        <source>Show the hidden objects again</source>
        <translation>包括已隐藏的物体</translation>
    </message>
    <message>
        <source>glDrawArrays: the objects are as they were drawn before</source>
        <translation>glDrawArrays：物体沿用上一次的绘制结果</translation>
    </message>
    <message>
        <source>Pick and Copy Point</source>
        <translation>拾取并复制点</translation>
    </message>
    <message>
        <source>Read the world coordinate of this pixel and copy it with all digits</source>
        <translation>读取此像素的世界坐标并复制其全部数字</translation>
    </message>
    <message>
        <source>Background: no surface here</source>
        <translation>背景：此处没有表面</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ScreenshotRun</name>
    <message>
        <source>%1 is also opened and would be overwritten; give the image another name.</source>
        <translation>%1 也是要打开的文件，会被覆盖；请给图像另取一个名称。</translation>
    </message>
    <message>
        <source>The click %1,%2 lies outside the view, which is %3 × %4 logical pixels.</source>
        <translation>点击 %1,%2 在视图之外，视图为 %3 × %4 逻辑像素。</translation>
    </message>
    <message>
        <source>The click %1,%2 could not be read.</source>
        <translation>无法读取点击 %1,%2。</translation>
    </message>
    <message>
        <source>%1 is not an image name; end it with .png.</source>
        <translation>%1 不是图像的文件名；请让它以 .png 结尾。</translation>
    </message>
    <message>
        <source>The clicks could not be written to standard output: %1.</source>
        <translation>无法把点击写到标准输出：%1。</translation>
    </message>
    <message>
        <source>The view is %1 × %2 logical pixels, not %3 × %4: the window cannot have that size here. Try --no-panels.</source>
        <translation>视图是 %1 × %2 逻辑像素，而不是 %3 × %4：窗口在此处无法做到。--no-panels 可给它更多空间。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SeriesFiles</name>
    <message>
        <source>%1 has no backup: %2.</source>
        <translation>%1 没有备份：%2。</translation>
    </message>
    <message>
        <source>%1: this file is no template: it has the landmarks of several specimens.</source>
        <translation>%1：此文件不是模板：其中有多个标本的标志点。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SeriesHistory</name>
    <message>
        <source>%1 on %2</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>“%1” on %2 cannot be redone: its landmarks have changed since.</source>
        <translation>无法重做 %2 上的“%1”：它的标志点此后已改变。</translation>
    </message>
    <message>
        <source>“%1” on %2 cannot be undone: its landmarks have changed since.</source>
        <translation>无法撤销 %2 上的“%1”：它的标志点此后已改变。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SeriesModel</name>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Placed</source>
        <translation>已放置</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SeriesPanel</name>
    <message>
        <source>Scans of the series</source>
        <translation>系列中的扫描</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>文件夹…</translation>
    </message>
    <message>
        <source>Open a folder of scans and place the same landmarks on each</source>
        <translation>打开一个扫描文件夹，在每个扫描上放置相同的标志点</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>上一个</translation>
    </message>
    <message>
        <source>Keep the landmarks and show the previous scan (Ctrl+PgUp)</source>
        <translation>保留各标志点并显示上一个扫描 (Ctrl+PgUp)</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>Keep the landmarks and show the next scan (Ctrl+PgDown)</source>
        <translation>保留各标志点并显示下一个扫描 (Ctrl+PgDown)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Write the landmarks of all scans to one table</source>
        <translation>将所有扫描的标志点写入一个表格</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>遍次</translation>
    </message>
    <message>
        <source>Number of the pass through the series, or of the observer. Each placing has its own landmarks; Repeats shows their scatter</source>
        <translation>第几遍处理此系列，或由哪位观察者处理：每遍的标志点分别保存，“重复”给出它们的离散程度</translation>
    </message>
    <message>
        <source>Placing:</source>
        <translation>遍次：</translation>
    </message>
    <message>
        <source>No series is open</source>
        <translation>没有打开的系列</translation>
    </message>
    <message>
        <source>Open a Series of Scans</source>
        <translation>打开扫描系列</translation>
    </message>
    <message>
        <source>One row per scan (%1)</source>
        <translation>每个扫描一行 (%1)</translation>
    </message>
    <message>
        <source>One row per landmark (%1)</source>
        <translation>每个标志点一行 (%1)</translation>
    </message>
    <message>
        <source>TPS of geomorph and tpsDig (%1)</source>
        <translation>geomorph 与 tpsDig 的 TPS (%1)</translation>
    </message>
    <message>
        <source>NTSYS (%1)</source>
        <translation>NTSYS (%1)</translation>
    </message>
    <message>
        <source>Export Landmarks of All Scans</source>
        <translation>导出所有扫描的标志点</translation>
    </message>
    <message>
        <source>Repeats…</source>
        <translation>重复测量…</translation>
    </message>
    <message>
        <source>Repeats: Mean and Error of All Placings</source>
        <translation>重复测量：各次放置的平均值与误差</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>表格 (%1)</translation>
    </message>
    <message>
        <source>Show how well each landmark is repeated: its error of measurement over all placings</source>
        <translation>显示每个标志点重复得多好：它在所有遍次中的测量误差</translation>
    </message>
    <message>
        <source>Out of Place</source>
        <translation>位置不对</translation>
    </message>
    <message>
        <source>Show how far each landmark is from where the other scans put it, the worst first</source>
        <translation>显示每个标志点离其他扫描给出的位置多远，最差的在前</translation>
    </message>
    <message>
        <source>Measuring along the surfaces…</source>
        <translation>正在沿各曲面测量…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Repeats: Error of Each Landmark</source>
        <translation>重复测量：每个标志点的误差</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SeriesPictures</name>
    <message>
        <source>%1 is not a folder and cannot be created. Give --screenshots another folder.</source>
        <translation>%1 不是文件夹，也无法创建。请给 --screenshots 另一个文件夹。</translation>
    </message>
    <message>
        <source>OpenGL has no memory for an image of %1 × %2 pixels. Choose a smaller --size.</source>
        <translation>OpenGL 没有足够内存绘制 %1 × %2 像素的图像。请选择更小的 --size。</translation>
    </message>
    <message>
        <source>%1 of %2: %3: %4</source>
        <translation>%1 / %2：%3：%4</translation>
    </message>
    <message>
        <source>There is no memory for the image %1.</source>
        <translation>没有足够内存生成图像 %1。</translation>
    </message>
    <message>
        <source>Images of %1 scans and %2 written to %3. Scans that could not be read: %4.</source>
        <translation>已将 %1 个扫描的图像和 %2 写入 %3。无法读取的扫描：%4。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SeriesProtocol</name>
    <message>
        <source>%1 could not be read and is not overwritten. Repair it or move it away to keep the measures.</source>
        <translation>%1 无法读取，不会被覆盖。要保留测量值，请修复它或把它移走。</translation>
    </message>
    <message>
        <source>Another window or program has changed %1 since it was read. It is not overwritten; move it away to keep the measures.</source>
        <translation>%1 读取之后被另一个窗口或程序更改。它不会被覆盖；要保留测量值，请把它移走。</translation>
    </message>
    <message>
        <source>The protocol now measures “%1” instead of “%2”. Scans that still have “%2”: %3. Rename it there too.</source>
        <translation>测量方案现在测量“%1”，不再是“%2”。仍有“%2”的扫描：%3。请在那里也改名。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SeriesTable</name>
    <message>
        <source>Scans that were placed more than once: %1; placings up to number %2.</source>
        <translation>放置不止一次的扫描：%1 个；放置序号最大为 %2。</translation>
    </message>
    <message>
        <source>No scan was placed more than once, so there is no scatter: set Placing to 2 and go through the scans again.</source>
        <translation>没有放置不止一次的扫描，因此没有离散程度：把“遍次”设为 2，再把各扫描过一遍。</translation>
    </message>
    <message>
        <source>%1: the series uses this file and it would be destroyed. Choose another name.</source>
        <translation>%1：系列中已有此文件，写入会毁掉它。请另给一个名称。</translation>
    </message>
    <message>
        <source>No scan of the series has a landmark yet. Place one first.</source>
        <translation>此系列的扫描上还没有任何标志点。请先放置一个。</translation>
    </message>
    <message>
        <source>Missing in %1, because they could not be read:</source>
        <translation>以下内容无法读取，因此不在 %1 中：</translation>
    </message>
    <message>
        <source>Repeats written to %1.</source>
        <translation>重复测量已写入 %1。</translation>
    </message>
    <message>
        <source>Scans written to %1: %2. Left out, without a landmark: %3.</source>
        <translation>已写入 %1 的扫描：%2。没有标志点而未写入的：%3。</translation>
    </message>
    <message>
        <source>Scans written to %1: %2.</source>
        <translation>写入 %1 的扫描：%2 个。</translation>
    </message>
    <message>
        <source>Placing shown: %1.</source>
        <translation>所显示的遍次：%1。</translation>
    </message>
    <message>
        <source>The export was cancelled. %1 was not written.</source>
        <translation>导出已取消。%1 未写出。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::Session</name>
    <message>
        <source>Large models are not simplified while the view moves: %1.</source>
        <translation>视图移动时大型模型未被简化：%1。</translation>
    </message>
    <message>
        <source>the scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Saved. The projection and the view have changed since they were given as matrices; they are saved as arguments.</source>
        <translation>已保存。投影变换和观察变换原以矩阵给出，读入后有改动，现按参数写出。</translation>
    </message>
    <message>
        <source>Saved. The projection has changed since it was given as a matrix; it is saved as arguments.</source>
        <translation>已保存。投影原为矩阵，读入后有改动，现按参数写出。</translation>
    </message>
    <message>
        <source>Saved. The view has changed since it was given as a matrix; it is saved as eye, center and up.</source>
        <translation>已保存。观察变换原以矩阵给出，读入后有改动，现以 eye、center 和 up 写出。</translation>
    </message>
    <message>
        <source>Unsaved changes are not protected from a crash, because they cannot be kept.</source>
        <translation>未保存的更改无法保留；如果程序意外退出，这些更改将会丢失。</translation>
    </message>
    <message>
        <source>Save the scene.</source>
        <translation>请保存场景。</translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier session are damaged and cannot be recovered. The file was kept as %1.</source>
        <translation>先前未保存的更改已损坏，无法恢复。该文件已移开，现为 %1。</translation>
    </message>
    <message>
        <source>The unsaved changes are damaged and cannot be recovered. The file was kept as %1.
%2</source>
        <translation>未保存的更改已损坏，无法恢复。该文件已移开，现为 %1。
%2</translation>
    </message>
    <message>
        <source>Bundled scene</source>
        <translation>自带场景</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Opening of %1 cancelled. The scene is as it was.</source>
        <translation>已取消打开 %1，场景保持原样。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ShadingFeature</name>
    <message>
        <source>The curvature is not shown: %1.</source>
        <translation>曲率未显示：%1。</translation>
    </message>
    <message>
        <source>Sha&amp;ding</source>
        <translation>明暗(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Light from the Side</source>
        <translation>侧光(&amp;L)</translation>
    </message>
    <message>
        <source>Light the surface from one side, so that ridges and wrinkles show. Ctrl + Shift + drag turns the light</source>
        <translation>从一侧照亮表面，使隆起和皱纹显现。Ctrl + Shift + 拖动转动这束光</translation>
    </message>
    <message>
        <source>&amp;Curvature</source>
        <translation>曲率(&amp;C)</translation>
    </message>
    <message>
        <source>Draw ridges light and valleys dark, in any light</source>
        <translation>隆起处画得浅，凹陷处画得深，与光无关</translation>
    </message>
    <message>
        <source>C&amp;olours and Textures</source>
        <translation>颜色和纹理(&amp;O)</translation>
    </message>
    <message>
        <source>Show the colours of the model; without them, the surface is grey</source>
        <translation>显示模型的颜色；没有颜色时表面为灰色</translation>
    </message>
    <message>
        <source>&amp;Edges of Triangles</source>
        <translation>三角形的边(&amp;E)</translation>
    </message>
    <message>
        <source>Draw the edges of triangles that are more than a few pixels large</source>
        <translation>画出大于几个像素的三角形的边</translation>
    </message>
    <message>
        <source>Clip &amp;at the Pick</source>
        <translation>在拾取处裁剪(&amp;A)</translation>
    </message>
    <message>
        <source>Cut away everything in front of the picked point, across the view</source>
        <translation>垂直于视线方向，切去所拾取的点之前的一切</translation>
    </message>
    <message>
        <source>Clip &amp;Through the Last Two Picks</source>
        <translation>通过最近两次拾取裁剪(&amp;T)</translation>
    </message>
    <message>
        <source>Cut along the line through the last two picked points, straight away from the eye</source>
        <translation>沿最近所拾取的两点的连线，顺着视线方向切开</translation>
    </message>
    <message>
        <source>&amp;Flip the Last Clip Plane</source>
        <translation>翻转最后一个裁剪平面(&amp;F)</translation>
    </message>
    <message>
        <source>Keep the other side of the last clip plane</source>
        <translation>保留最后一个裁剪平面的另一侧</translation>
    </message>
    <message>
        <source>&amp;Remove the Last Clip Plane</source>
        <translation>移除最后一个裁剪平面(&amp;R)</translation>
    </message>
    <message>
        <source>Show what the last clip plane has cut away</source>
        <translation>显示最后一个裁剪平面切去的部分</translation>
    </message>
    <message>
        <source>The scene has %1 clip planes, and takes no more. Remove one first.</source>
        <translation>场景已有 %1 个裁剪平面，不能再多。请先移除一个。</translation>
    </message>
    <message>
        <source>The two points are behind each other in this view. Turn the view, or pick another point.</source>
        <translation>这两点在此视图中前后重合。请转动视图，或拾取另一个点。</translation>
    </message>
    <message>
        <source>The clip plane could not be set here.</source>
        <translation>无法在此处放置裁剪平面。</translation>
    </message>
    <message>
        <source>Click a point of the surface first: the clip plane goes through it.</source>
        <translation>请先点击表面上的一个点：裁剪平面将通过它。</translation>
    </message>
    <message>
        <source>Click two points of the surface first: the clip plane goes through them.</source>
        <translation>请先点击表面上的两个点：裁剪平面将通过它们。</translation>
    </message>
    <message>
        <source>The curvature was cancelled. Press C to compute it.</source>
        <translation>已取消计算曲率。按 C 可重新计算。</translation>
    </message>
    <message>
        <source>Ridges are light, valleys are dark. Smoothed over %1 units.</source>
        <translation>隆起处浅，凹陷处深。平滑范围为 %1 个单位。</translation>
    </message>
    <message>
        <source>No object has a surface with a curvature.</source>
        <translation>没有物体具有带曲率的表面。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ShownScan</name>
    <message>
        <source>Landmarks of the scan</source>
        <translation>扫描的标志点</translation>
    </message>
    <message>
        <source>The landmarks of %1 are not saved yet: %2.</source>
        <translation>%1 的标志点尚未保存：%2。</translation>
    </message>
    <message>
        <source>The landmarks of %1 cannot be saved: because of the object&apos;s scale they have no coordinates in its file. Reset its glScale.</source>
        <translation>无法保存 %1 的标志点：按物体的缩放，它们在其文件中没有坐标。请把它的 glScale 改回去。</translation>
    </message>
    <message>
        <source>Another window or program has changed %1 since it was read. It is not overwritten; move it away to keep the shown landmarks.</source>
        <translation>%1 在此处读取之后已被另一个窗口或程序修改，不会被覆盖；要保存所显示的标志点，请先把该文件移走。</translation>
    </message>
    <message>
        <source>Landmarks of %1 saved in %2.</source>
        <translation>%1 的标志点已保存到 %2。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SpaceChoice</name>
    <message>
        <source>Space of the points that the program got</source>
        <translation>程序所得的点所在的空间</translation>
    </message>
    <message>
        <source>Space in which the program expresses its points</source>
        <translation>程序的点是哪个空间里的</translation>
    </message>
    <message>
        <source>World</source>
        <translation>世界</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>观察</translation>
    </message>
    <message>
        <source>Object: %1</source>
        <translation>物体：%1</translation>
    </message>
    <message>
        <source>Object: %1 (removed)</source>
        <translation>物体：%1（已移除）</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::StageText</name>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>View</source>
        <translation>观察</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Viewport</source>
        <translation>视口</translation>
    </message>
    <message>
        <source>Modelview</source>
        <translation>模型视图</translation>
    </message>
    <message>
        <source>%1, depth as read</source>
        <translation>%1，深度为读取值</translation>
    </message>
    <message>
        <source>%1, depth computed</source>
        <translation>%1，深度为计算值</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::StartOptions</name>
    <message>
        <source>Click a pixel of a 3-D view and get its world coordinate, computed twice.</source>
        <translation>点击三维视图中的一个像素，用两种方法求出它的世界坐标。</translation>
    </message>
    <message>
        <source>Open, save an image of the whole window, print the clicks as JSON, and quit.</source>
        <translation>打开程序，把整个窗口保存为图像，以 JSON 输出各次点击的结果，然后退出。</translation>
    </message>
    <message>
        <source>With --screenshot: press the left button at this position of the view, logical pixels from its top-left corner. May be given several times.</source>
        <translation>与 --screenshot 连用：在视图的这个位置按下左键，以逻辑像素计，原点在视图左上角。可以给出多次。</translation>
    </message>
    <message>
        <source>Print this help and quit.</source>
        <translation>显示程序的用法并退出。</translation>
    </message>
    <message>
        <source>%1 See --help.</source>
        <translation>%1 参见 --help。</translation>
    </message>
    <message>
        <source>--click is %1; give x,y in logical pixels of the view, such as 412,300.</source>
        <translation>--click 为 %1；请给出以视图逻辑像素计的 x,y，例如 412,300。</translation>
    </message>
    <message>
        <source>--click works together with --screenshot OUT.png.</source>
        <translation>--click 须与 --screenshot OUT.png 连用。</translation>
    </message>
    <message>
        <source>Draw smooth edges: on or off. Clicks read the same depths either way.</source>
        <translation>是否把表面的边缘画得没有锯齿：on 或 off。点击读到的内容不变。</translation>
    </message>
    <message>
        <source>--smooth-edges is %1; give on or off.</source>
        <translation>--smooth-edges 为 %1；请给出 on 或 off。</translation>
    </message>
    <message>
        <source>Size of the view itself in logical pixels, instead of --size. The same clicks then mean the same pixels for every font and language.</source>
        <translation>视图本身的大小（逻辑像素），与面板的字体和语言无关：同样的点击在任何机器上都是同样的像素。代替 --size。</translation>
    </message>
    <message>
        <source>Give the view the whole window.</source>
        <translation>让视图占满整个窗口。</translation>
    </message>
    <message>
        <source>Colours of the window: desktop (the system&apos;s; default), light or dark.</source>
        <translation>窗口的颜色：desktop（与桌面相同，默认）、light（浅色）或 dark（深色）。</translation>
    </message>
    <message>
        <source>Give --size or --view-size, not both.</source>
        <translation>--size 和 --view-size 只能给一个。</translation>
    </message>
    <message>
        <source>--place is %1; give one of: %2.</source>
        <translation>--place 是 %1；请给出其中之一：%2。</translation>
    </message>
    <message>
        <source>--appearance is %1; give desktop, light or dark.</source>
        <translation>--appearance 是 %1；请给出 desktop、light 或 dark。</translation>
    </message>
    <message>
        <source>--%1 is %2; give width x height in pixels, such as 1280x800, from %3x%4 to %5x%6.</source>
        <translation>--%1 是 %2；请给出以像素为单位的宽 x 高，例如 1280x800，范围从 %3x%4 到 %5x%6。</translation>
    </message>
    <message>
        <source>Workspace to start in: %1. Default: the one used last; with --screenshot the first.</source>
        <translation>启动时的工作区：%1。不指定时为上次的工作区；截图时为第一个。</translation>
    </message>
    <message>
        <source>A scene, or model files (OBJ, STL, PLY, OFF, glTF, GLB) with files of landmarks. Default: the bundled scene.</source>
        <translation>一个场景，或模型文件：OBJ、STL、PLY、OFF、glTF、GLB；旁边可再给标志点文件。都不给时为自带的场景。</translation>
    </message>
    <message>
        <source>Language of the program: system (the desktop&apos;s; default), en or zh_CN.</source>
        <translation>程序的语言：system（随桌面；默认）、en 或 zh_CN。</translation>
    </message>
    <message>
        <source>--language is %1; give system, en or zh_CN.</source>
        <translation>--language 是 %1；请给出 system、en 或 zh_CN。</translation>
    </message>
    <message>
        <source>Start with a lesson or with one of its steps. Examples: weng, weng:3.</source>
        <translation>从一门课程或其中一步开始：first、weng:3。</translation>
    </message>
    <message>
        <source>Give --lesson or files to open, not both.</source>
        <translation>--lesson 与要打开的文件只能给出其一。</translation>
    </message>
    <message>
        <source>Open a folder of scans as a series. The landmarks of each scan are saved beside it.</source>
        <translation>将一个扫描文件夹作为系列打开。每个扫描的标志点保存在它旁边。</translation>
    </message>
    <message>
        <source>With --series: write an image of each scan with its landmarks, and contact-sheet.png with all of them, to this folder, and quit.</source>
        <translation>与 --series 一起：将每个扫描连同其标志点的图像，以及包含全部扫描的 contact-sheet.png 写入此文件夹，然后退出。</translation>
    </message>
    <message>
        <source>Size of the window in logical pixels (default 1280x800); with --screenshots, of each image.</source>
        <translation>窗口大小，逻辑像素（默认 1280x800）；与 --screenshots 一起时为每张图像的大小。</translation>
    </message>
    <message>
        <source>Give --series alone, without --lesson and without files to open.</source>
        <translation>--series 请单独使用，不要同时给出 --lesson 或要打开的文件。</translation>
    </message>
    <message>
        <source>--screenshots works together with --series FOLDER.</source>
        <translation>--screenshots 须与 --series FOLDER 一起使用。</translation>
    </message>
    <message>
        <source>--screenshot writes one image. For a series, give --screenshots OUT.</source>
        <translation>--screenshot 只写一张图像。对系列请用 --screenshots OUT。</translation>
    </message>
    <message>
        <source>With --screenshots: the side that the images show: front, back, right, left, top or bottom. Default: the view in which the series opens.</source>
        <translation>与 --screenshots 一起：图像显示的一侧：front、back、right、left、top 或 bottom。默认为系列打开时的视图。</translation>
    </message>
    <message>
        <source>--view is %1; give front, back, right, left, top or bottom.</source>
        <translation>--view 为 %1；请给出 front、back、right、left、top 或 bottom。</translation>
    </message>
    <message>
        <source>--view works together with --screenshots OUT.</source>
        <translation>--view 须与 --screenshots OUT 一起使用。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::StatusReadout</name>
    <message>
        <source>World coordinate under the pointer</source>
        <translation>指针处的世界坐标</translation>
    </message>
    <message>
        <source>World coordinate under the pointer, without digits smaller than the uncertainty</source>
        <translation>指针处的世界坐标，只显示在其像素之内可靠的数位</translation>
    </message>
    <message>
        <source>background, %1</source>
        <translation>背景，%1</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Projection and distances of the near and far planes, world units</source>
        <translation>投影方式，以及近、远平面的距离，世界单位</translation>
    </message>
    <message>
        <source>Clicks already use the depth buffer; the ray follows when the model is prepared for it</source>
        <translation>点击已有深度缓冲的结果；模型准备好后即有射线的结果</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>像素 (%1, %2)</translation>
    </message>
    <message>
        <source>world %1, %2</source>
        <translation>世界坐标 %1，%2</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>透视投影</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>斜投影</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>正投影</translation>
    </message>
    <message>
        <source>%1, near %2, far %3</source>
        <translation>%1，近 %2，远 %3</translation>
    </message>
    <message>
        <source>Preparing the exact hit</source>
        <translation>正在准备精确交点</translation>
    </message>
    <message>
        <source>Preparing the exact hit: %1 %</source>
        <translation>正在准备精确交点：%1 %</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::SteadyLabel</name>
    <message>
        <source>Copy the &amp;selection</source>
        <translation>复制选中的文字(&amp;S)</translation>
    </message>
    <message>
        <source>Copy the &amp;text</source>
        <translation>复制文字(&amp;W)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::StretchBar</name>
    <message>
        <source>Letterbox</source>
        <translation>留边</translation>
    </message>
    <message>
        <source>Stretched view</source>
        <translation>图像被拉伸</translation>
    </message>
    <message>
        <source>Give the viewport the aspect of the projection, with bars beside or above it</source>
        <translation>让视口采用投影的宽高比，两侧或上下留边</translation>
    </message>
    <message>
        <source>Keep the view stretched and close this message</source>
        <translation>保持图像拉伸，并关闭此消息</translation>
    </message>
    <message>
        <source>Projection %1, viewport %2: the view is stretched.</source>
        <extracomment>Two aspects, width to height, such as 4 : 3 and 1.11 : 1.</extracomment>
        <translation>投影 %1，视口 %2：图像被拉伸。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ThenAndNow</name>
    <message>
        <source>frustum</source>
        <translation>透视（glFrustum）</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>正交</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>斜投影</translation>
    </message>
    <message>
        <source>Eye position</source>
        <translation>视点位置</translation>
    </message>
    <message>
        <source>View direction</source>
        <translation>视线方向</translation>
    </message>
    <message>
        <source>Up direction</source>
        <translation>向上方向</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Vertical field of view</source>
        <translation>垂直视场角</translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation>宽高比</translation>
    </message>
    <message>
        <source>Projection window</source>
        <translation>投影窗口</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>近</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>Window x</source>
        <translation>窗口 x</translation>
    </message>
    <message>
        <source>Window y</source>
        <translation>窗口 y</translation>
    </message>
    <message>
        <source>Window depth</source>
        <translation>窗口深度</translation>
    </message>
    <message>
        <source>Eye x</source>
        <translation>观察 x</translation>
    </message>
    <message>
        <source>Eye y</source>
        <translation>观察 y</translation>
    </message>
    <message>
        <source>Eye z</source>
        <translation>观察 z</translation>
    </message>
    <message>
        <source>World x</source>
        <translation>世界 x</translation>
    </message>
    <message>
        <source>World y</source>
        <translation>世界 y</translation>
    </message>
    <message>
        <source>World z</source>
        <translation>世界 z</translation>
    </message>
    <message>
        <source>Now the point is outside the view volume: %1.</source>
        <translation>该点现在位于视景体之外：%1。</translation>
    </message>
    <message>
        <source>Viewport</source>
        <translation>视口</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>深度范围</translation>
    </message>
    <message>
        <source>Window size</source>
        <translation>窗口大小</translation>
    </message>
    <message>
        <source>Pixel ratio</source>
        <translation>像素比</translation>
    </message>
    <message>
        <source>Centre of the projection window at near 1</source>
        <translation>近平面距离为 1 时投影窗口的中心</translation>
    </message>
    <message>
        <source>Shear angles</source>
        <translation>错切角</translation>
    </message>
    <message>
        <source>Skew</source>
        <translation>倾斜</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ThenAndNowView</name>
    <message>
        <source>The picked point at the click and now</source>
        <translation>点击时与现在的拾取点</translation>
    </message>
    <message>
        <source>Where a coordinate differs, its row is bold and has a “≠” behind its name</source>
        <translation>坐标不同的行以粗体显示，名称后带“≠”</translation>
    </message>
    <message>
        <source>At the click</source>
        <translation>点击时</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>Changes of the setup since the click</source>
        <translation>点击之后设置的变化</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::TypedNumbers</name>
    <message>
        <source>“%1” is not a size: type width and height in whole pixels, such as 1000 x 700.</source>
        <translation>“%1”不是大小：请键入以整像素表示的宽和高，例如 1000 x 700。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::VerdictView</name>
    <message>
        <source>Do the methods agree?</source>
        <translation>两种方法是否一致</translation>
    </message>
    <message>
        <source>&amp;Why?</source>
        <translation>为什么(&amp;W)？</translation>
    </message>
    <message>
        <source>Cause of the difference, and uncertainty of the coordinate</source>
        <translation>差从何而来，坐标可能偏差多少</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>Cause of the difference</source>
        <translation>差异的原因</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ViewGroup</name>
    <message>
        <source>Eye</source>
        <translation>视点</translation>
    </message>
    <message>
        <source>Eye %1</source>
        <translation>视点 %1</translation>
    </message>
    <message>
        <source>Position of the camera, world units (gluLookAt: eye%1)</source>
        <translation>相机的位置，世界单位 (gluLookAt: eye%1)</translation>
    </message>
    <message>
        <source>Center</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Center %1</source>
        <translation>目标点 %1</translation>
    </message>
    <message>
        <source>The point the camera looks at, world units (gluLookAt: center%1)</source>
        <translation>相机所看的点，世界单位 (gluLookAt: center%1)</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上方向</translation>
    </message>
    <message>
        <source>Up %1</source>
        <translation>上方向 %1</translation>
    </message>
    <message>
        <source>Direction that points up in the view; its length does not matter (gluLookAt: up%1)</source>
        <translation>画面中向上的方向；长度无关紧要 (gluLookAt: up%1)</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Position and direction of the camera (gluLookAt)</source>
        <translation>相机的位置 (gluLookAt)</translation>
    </message>
    <message>
        <source>Return to the scene&apos;s initial view</source>
        <translation>回到打开场景时的视图</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ViewResizer</name>
    <message>
        <source>The view is %1 × %2 now. It cannot be %3 × %4 on a screen scaled by %5: numbers differ a little from the text.</source>
        <extracomment>Sizes in pixels: what the view has, then what it should have; the last is the scale of the screen, such as 1.75.</extracomment>
        <translation>视图现在是 %1 × %2；在缩放 %5 倍的屏幕上无法达到 %3 × %4：数字会与文中的略有不同。</translation>
    </message>
    <message>
        <source>The view is %1 × %2 now: in this window it cannot be %3 × %4. Close panels beside it, or take the window out of full screen.</source>
        <extracomment>Sizes in pixels: what the view has, then what it should have.</extracomment>
        <translation>视图现在是 %1 × %2：在这个窗口中无法达到 %3 × %4。请关闭旁边的面板，或退出全屏。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ViewSizeDialog</name>
    <message>
        <source>View Size</source>
        <translation>视图大小</translation>
    </message>
    <message>
        <source>Width in logical pixels</source>
        <translation>宽度，逻辑像素</translation>
    </message>
    <message>
        <source>Width of the view as programs give it to a widget, logical pixels</source>
        <translation>视图的宽度，即程序给控件设定的宽度，逻辑像素</translation>
    </message>
    <message>
        <source>Height in logical pixels</source>
        <translation>高度，逻辑像素</translation>
    </message>
    <message>
        <source>Height of the view as programs give it to a widget, logical pixels</source>
        <translation>视图的高度，即程序给控件设定的高度，逻辑像素</translation>
    </message>
    <message>
        <source>Width in device pixels</source>
        <translation>宽度，设备像素</translation>
    </message>
    <message>
        <source>Width of the framebuffer (glViewport), device pixels</source>
        <translation>帧缓冲区的宽度（glViewport），设备像素</translation>
    </message>
    <message>
        <source>Height in device pixels</source>
        <translation>高度，设备像素</translation>
    </message>
    <message>
        <source>Height of the framebuffer (glViewport), device pixels</source>
        <translation>帧缓冲区的高度（glViewport），设备像素</translation>
    </message>
    <message>
        <source>Pixel ratio</source>
        <translation>像素比</translation>
    </message>
    <message>
        <source>Device pixels per logical pixel. This screen has %1</source>
        <translation>每个逻辑像素对应的设备像素数。此屏幕为 %1</translation>
    </message>
    <message>
        <source>How the view is shown</source>
        <translation>视图如何显示</translation>
    </message>
    <message>
        <source>Logical pixels</source>
        <translation>逻辑像素</translation>
    </message>
    <message>
        <source>× pixel ratio</source>
        <translation>× 像素比</translation>
    </message>
    <message>
        <source>= device pixels</source>
        <translation>= 设备像素</translation>
    </message>
    <message>
        <source>&amp;Fit the window</source>
        <translation>充满窗口(&amp;F)</translation>
    </message>
    <message>
        <source>Let the view fill the window</source>
        <translation>让视图占满窗口留给它的全部空间</translation>
    </message>
    <message>
        <source>Set &amp;size</source>
        <translation>设定大小(&amp;S)</translation>
    </message>
    <message>
        <source>Give the view this size and keep it in the scene</source>
        <translation>将视图设为此大小，并保存在场景中</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Leave the view as it is</source>
        <translation>视图保持不变</translation>
    </message>
    <message>
        <source>At this ratio no whole number of logical pixels makes %1 × %2 device pixels. %3 × %4 is the nearest size.</source>
        <translation>在此像素比下，没有整数个逻辑像素等于 %1 × %2 设备像素。最接近的大小是 %3 × %4。</translation>
    </message>
    <message>
        <source>The window is large enough: the view is shown pixel on pixel.</source>
        <translation>窗口容得下：逐像素显示。</translation>
    </message>
    <message>
        <source>The window is smaller: the view is drawn at this size and shown at %1 %. Clicks read its own pixels.</source>
        <translation>窗口容不下：按此大小绘制，缩小到 %1 % 显示。点击读取的是它本身的像素。</translation>
    </message>
    <message>
        <source>View size</source>
        <translation>视图大小</translation>
    </message>
    <message>
        <source>Fit the window</source>
        <translation>充满窗口</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ViewportDrawing</name>
    <message>
        <source>Window, viewport and projection window to scale</source>
        <translation>按比例绘制的窗口、视口和投影窗口</translation>
    </message>
    <message>
        <source>Left: the window with the viewport in it, to scale in device pixels.
Right: the projection window, to scale in eye units, with the lines x = 0 and y = 0.
The dot is the pointer. The viewport shows how the circle of the projection window is stretched.</source>
        <translation>左：窗口及其中的视口，按设备像素的比例。
右：投影窗口，按观察坐标单位的比例，带有直线 x = 0 和 y = 0。
圆点是指针；投影窗口中的圆，在视口中按它在那里的形状画出。</translation>
    </message>
    <message>
        <source>Window %1 × %2; viewport from (%3, %4), %5 × %6; projection window from %7 to %8 and from %9 to %10</source>
        <translation>窗口 %1 × %2；视口起点 (%3, %4)，大小 %5 × %6；投影窗口从 %7 到 %8、从 %9 到 %10</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Projection window</source>
        <translation>投影窗口</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>投影</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ViewportGroup</name>
    <message>
        <source>Part of the window</source>
        <translation>窗口的部分</translation>
    </message>
    <message>
        <source>Part of the window that the viewport covers (glViewport)</source>
        <translation>画面占窗口的哪一部分 (glViewport)</translation>
    </message>
    <message>
        <source>Whole window</source>
        <translation>整个窗口</translation>
    </message>
    <message>
        <source>glViewport(0, 0, width, height)</source>
        <translation>glViewport(0, 0, width, height)</translation>
    </message>
    <message>
        <source>Fixed rectangle</source>
        <translation>固定矩形</translation>
    </message>
    <message>
        <source>The same pixels for every size of the window</source>
        <translation>像素不变，与窗口大小无关</translation>
    </message>
    <message>
        <source>Keep aspect (letterbox)</source>
        <translation>保持宽高比（留边）</translation>
    </message>
    <message>
        <source>The largest rectangle of this aspect, centred, with bars beside or above it</source>
        <translation>该宽高比的最大矩形，居中，两侧或上下留边</translation>
    </message>
    <message>
        <source>Lower right quarter</source>
        <translation>右下四分之一</translation>
    </message>
    <message>
        <source>glViewport(width/2, 0, width/2, height/2)</source>
        <translation>glViewport(width/2, 0, width/2, height/2)</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge, whole device pixels from the left edge of the window (glViewport: x)</source>
        <translation>左边界，整数设备像素，从窗口左边界算起 (glViewport: x)</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Lower edge, whole device pixels from the lower edge of the window (glViewport: y)</source>
        <translation>下边界，整数设备像素，从窗口下边界算起 (glViewport: y)</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽</translation>
    </message>
    <message>
        <source>Width in whole device pixels, above 0 (glViewport: width)</source>
        <translation>宽，整数设备像素，大于 0 (glViewport: width)</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高</translation>
    </message>
    <message>
        <source>Height in whole device pixels, above 0 (glViewport: height)</source>
        <translation>高，整数设备像素，大于 0 (glViewport: height)</translation>
    </message>
    <message>
        <source>Viewport aspect</source>
        <translation>视口宽高比</translation>
    </message>
    <message>
        <source>Width divided by height of the rectangle, above 0</source>
        <translation>矩形的宽除以高，大于 0</translation>
    </message>
    <message>
        <source>Depth range in use</source>
        <translation>当前深度范围</translation>
    </message>
    <message>
        <source>The depth range in use: OpenGL takes its ends in single precision</source>
        <translation>当前深度范围：OpenGL 以单精度接受其两端</translation>
    </message>
    <message>
        <source>Viewport in use</source>
        <translation>当前视口</translation>
    </message>
    <message>
        <source>The viewport in use: x, y, width, height in device pixels from the lower left corner</source>
        <translation>当前视口：x、y、宽、高，设备像素，原点在左下角</translation>
    </message>
    <message>
        <source>Size of the window</source>
        <translation>窗口大小</translation>
    </message>
    <message>
        <source>Size of the window in device pixels</source>
        <translation>画面所在窗口的大小，以设备像素计</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>深度范围</translation>
    </message>
    <message>
        <source>Depth of the near plane</source>
        <translation>近平面的深度</translation>
    </message>
    <message>
        <source>Depth of the near plane, from 0 to 1; usually 0 (glDepthRange)</source>
        <translation>近平面所得的深度，从 0 到 1；通常为 0 (glDepthRange)</translation>
    </message>
    <message>
        <source>Depth of the far plane</source>
        <translation>远平面的深度</translation>
    </message>
    <message>
        <source>Depth of the far plane, from 0 to 1; usually 1 (glDepthRange)</source>
        <translation>远平面所得的深度，从 0 到 1；通常为 1 (glDepthRange)</translation>
    </message>
    <message>
        <source>Viewport %1</source>
        <translation>视口 %1</translation>
    </message>
    <message>
        <source>Window: %1 × %2 pixels</source>
        <translation>窗口：%1 × %2 像素</translation>
    </message>
    <message>
        <source>Viewport and depth</source>
        <translation>视口与深度</translation>
    </message>
    <message>
        <source>glViewport and glDepthRange</source>
        <translation>glViewport 和 glDepthRange</translation>
    </message>
    <message>
        <source>The whole window, depths from 0 to 1</source>
        <translation>整个窗口，深度从 0 到 1</translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation>宽高比</translation>
    </message>
    <message>
        <source>Near plane</source>
        <translation>近平面</translation>
    </message>
    <message>
        <source>Far plane</source>
        <translation>远平面</translation>
    </message>
    <message>
        <source>Window: %1 × %2 pixels, fixed</source>
        <translation>窗口：%1 × %2 像素，固定</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>更改…</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::ViewportInspector</name>
    <message>
        <source>Shown page</source>
        <translation>显示内容</translation>
    </message>
    <message>
        <source>Proportions</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>The proportions (3) and (4) with their numbers</source>
        <translation>代入数值的比例式 (3) 和 (4)</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>角点</translation>
    </message>
    <message>
        <source>The window&apos;s corners and centre in all coordinates</source>
        <translation>窗口的四角和中心在各种坐标中的值</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>The view&apos;s framebuffer in device pixels, and its pixel ratio</source>
        <translation>视图的帧缓冲，以设备像素计，以及一个逻辑像素含多少设备像素</translation>
    </message>
    <message>
        <source>Viewport</source>
        <translation>视口</translation>
    </message>
    <message>
        <source>x, y, width, height in device pixels from the window&apos;s bottom-left corner</source>
        <translation>x、y、宽、高，设备像素，原点在窗口左下角</translation>
    </message>
    <message>
        <source>x_w, y_w: the pointer in the projection window, eye units, of a perspective on the near plane
x_v, y_v: the centre of the pointer&apos;s pixel, device pixels from the window&apos;s bottom-left corner
vx, vy, width, height: the viewport; left, right, bottom, top: the projection window</source>
        <translation>x_w, y_w：投影窗口中的指针，观察坐标单位，透视投影时在近平面上
x_v, y_v：指针所在像素的中心，设备像素，原点在窗口左下角
vx, vy, width, height：视口；left, right, bottom, top：投影窗口</translation>
    </message>
    <message>
        <source>Shape of a circle</source>
        <translation>圆的形状</translation>
    </message>
    <message>
        <source>Corners and centre of the window</source>
        <translation>窗口的四角和中心</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>全部复制</translation>
    </message>
    <message>
        <source>Window %1 × %2 device pixels, device pixel ratio %3</source>
        <translation>窗口 %1 × %2 设备像素，设备像素比 %3</translation>
    </message>
    <message>
        <source>Shape of a circle parallel to the projection plane: the viewport is %1 : 1, the projection window %2 : 1</source>
        <translation>对平行于投影平面的圆：视口为 %1 : 1，投影窗口为 %2 : 1</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>图示</translation>
    </message>
    <message>
        <source>Window, viewport and projection window, drawn to scale</source>
        <translation>窗口、视口和投影窗口，按比例绘制</translation>
    </message>
    <message>
        <source>Proportion (3)</source>
        <translation>比例式 (3)</translation>
    </message>
    <message>
        <source>Numbers of proportion (3)</source>
        <translation>比例式 (3) 的数值</translation>
    </message>
    <message>
        <source>Proportion (4)</source>
        <translation>比例式 (4)</translation>
    </message>
    <message>
        <source>Numbers of proportion (4)</source>
        <translation>比例式 (4) 的数值</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>更改…</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::WindowMenus</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open model files or a scene</source>
        <translation>打开模型文件或场景</translation>
    </message>
    <message>
        <source>Open Models or a Scene</source>
        <translation>打开模型或场景</translation>
    </message>
    <message>
        <source>Scenes (*.json)</source>
        <translation>场景 (*.json)</translation>
    </message>
    <message>
        <source>A&amp;dd to Scene…</source>
        <translation>添加到场景(&amp;D)…</translation>
    </message>
    <message>
        <source>Add more models to this scene</source>
        <translation>把更多模型放到此场景的物体旁</translation>
    </message>
    <message>
        <source>Add Models</source>
        <translation>添加模型</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save Scene</source>
        <translation>保存场景(&amp;S)</translation>
    </message>
    <message>
        <source>Save Scene &amp;As…</source>
        <translation>场景另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Write the scene to another file</source>
        <translation>将场景写入另一个文件</translation>
    </message>
    <message>
        <source>Sce&amp;ne as Code…</source>
        <translation>场景代码(&amp;N)…</translation>
    </message>
    <message>
        <source>Show the calls of this setup, for GLU and MFC, GLM, Qt, three.js or NumPy, with the inverse from a pixel</source>
        <translation>生成这幅画面的调用（GLU 与 MFC、GLM、Qt、three.js 或 NumPy），以及从像素反算回去的函数</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>关闭窗口</translation>
    </message>
    <message>
        <source>&amp;Clear This List</source>
        <translation>清空列表(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>适合窗口(&amp;F)</translation>
    </message>
    <message>
        <source>Move the camera until all objects fill the view</source>
        <translation>移动相机，使所有物体充满视图</translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation>初始视图(&amp;H)</translation>
    </message>
    <message>
        <source>Return to the scene&apos;s initial camera</source>
        <translation>回到场景打开时的相机</translation>
    </message>
    <message>
        <source>Fr&amp;ont</source>
        <translation>前视(&amp;O)</translation>
    </message>
    <message>
        <source>Look from the front, along −z</source>
        <translation>从前方看，沿 −z 方向</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>右视(&amp;R)</translation>
    </message>
    <message>
        <source>Look from the right, along −x</source>
        <translation>从右方看，沿 −x 方向</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>俯视(&amp;T)</translation>
    </message>
    <message>
        <source>Look from the top, along −y</source>
        <translation>从上方看，沿 −y 方向</translation>
    </message>
    <message>
        <source>B&amp;ack</source>
        <translation>后视(&amp;A)</translation>
    </message>
    <message>
        <source>Look from the back, along z</source>
        <translation>从后方看，沿 z 方向</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左视(&amp;L)</translation>
    </message>
    <message>
        <source>Look from the left, along x</source>
        <translation>从左方看，沿 x 方向</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>仰视(&amp;M)</translation>
    </message>
    <message>
        <source>Look from below, along y</source>
        <translation>从下方看，沿 y 方向</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>透视投影(&amp;P)</translation>
    </message>
    <message>
        <source>Switch between perspective (glFrustum) and orthographic (glOrtho)</source>
        <translation>在透视投影 (glFrustum) 与正投影 (glOrtho) 之间切换</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Smooth Edges</source>
        <translation>平滑边缘(&amp;S)</translation>
    </message>
    <message>
        <source>Draw smooth edges of surfaces. Clicks read the same depths</source>
        <translation>把表面的边缘画得没有锯齿。点击读到的深度不变</translation>
    </message>
    <message>
        <source>Co&amp;lours</source>
        <translation>颜色(&amp;L)</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>语言 Language(&amp;G)</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is</source>
        <translation>浅色或深色，与桌面一致</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Dark letters on a light ground</source>
        <translation>浅底深字</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>深色(&amp;A)</translation>
    </message>
    <message>
        <source>Light letters on a dark ground</source>
        <translation>深底浅字</translation>
    </message>
    <message>
        <source>H&amp;ide All Panels</source>
        <translation>隐藏所有面板(&amp;I)</translation>
    </message>
    <message>
        <source>Give the view the whole window</source>
        <translation>让视图占满整个窗口</translation>
    </message>
    <message>
        <source>R&amp;eset Layout</source>
        <translation>恢复布局(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Mouse and Keys</source>
        <translation>鼠标与键盘(&amp;M)</translation>
    </message>
    <message>
        <source>List of mouse actions and keys</source>
        <translation>鼠标和每个按键的作用</translation>
    </message>
    <message>
        <source>&amp;About Unprojector</source>
        <translation>关于 Unprojector(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licence of the program</source>
        <translation>本程序的用途</translation>
    </message>
    <message>
        <source>This graphics driver cannot draw integers, so the view identifies clicked objects by colours.</source>
        <translation>此显卡驱动不能绘制整数，因此视图用颜色判断点击的是哪个物体。</translation>
    </message>
    <message>
        <source>&amp;Export Image…</source>
        <translation>导出图像(&amp;E)…</translation>
    </message>
    <message>
        <source>Write only the view as a PNG image, at any size, with or without markers</source>
        <translation>只把视图写为 PNG 文件，大小任意，可带或不带标记</translation>
    </message>
    <message>
        <source>View Si&amp;ze…</source>
        <translation>视图大小(&amp;Z)…</translation>
    </message>
    <message>
        <source>Set the view&apos;s size in pixels, to match a program or an article</source>
        <translation>按程序或文章中的像素数设定视图大小</translation>
    </message>
    <message>
        <source>Fit the Wi&amp;ndow</source>
        <translation>充满窗口(&amp;N)</translation>
    </message>
    <message>
        <source>Let the view fill the window</source>
        <translation>让视图占满窗口留给它的全部空间</translation>
    </message>
    <message>
        <source>&amp;Workspace</source>
        <translation>工作区(&amp;W)</translation>
    </message>
    <message>
        <source>Restore the default layout of this workspace</source>
        <translation>把此工作区的所有面板放回最初的位置</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Prefere&amp;nces…</source>
        <translation>首选项(&amp;N)…</translation>
    </message>
    <message>
        <source>Colours, language, smooth edges; first steps and layout can be reset</source>
        <translation>颜色、语言、平滑边缘；把入门提示和布局恢复为最初状态</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>Ma&amp;nual</source>
        <translation>手册(&amp;N)</translation>
    </message>
    <message>
        <source>How to do each task in this window, with contents and search</source>
        <translation>如何在本窗口中完成每项任务，带目录和搜索</translation>
    </message>
    <message>
        <source>Manual of This &amp;Panel</source>
        <translation>本面板的手册(&amp;P)</translation>
    </message>
    <message>
        <source>The page of the manual on the panel that has the focus, or on that of the workspace</source>
        <translation>手册中关于焦点所在面板的页面；焦点不在面板时，为工作区的面板</translation>
    </message>
    <message>
        <source>Manual, formulas, keys, version and licence</source>
        <translation>手册、公式、按键、版本与许可</translation>
    </message>
    <message>
        <source>Write the scene to its file; in a series, the landmarks beside their scan</source>
        <translation>将场景写入其文件；在系列中则将标志点写在扫描旁边</translation>
    </message>
    <message>
        <source>&amp;Save Landmarks of the Scan</source>
        <translation>保存扫描的标志点(&amp;S)</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>已撤销：%1。</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>已重做：%1。</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::WindowQuestions</name>
    <message>
        <source>Unsaved Changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>要保存对“%1”的更改吗？</translation>
    </message>
    <message>
        <source>Save Scene</source>
        <translation>保存场景</translation>
    </message>
    <message>
        <source>Scenes (*.json)</source>
        <translation>场景 (*.json)</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 已存在。要替换它吗？</translation>
    </message>
    <message>
        <source>%1 has been changed by another window or program since it was opened here. Replace it, and lose those changes?</source>
        <translation>%1 在此处打开之后已被其他窗口或程序更改。要替换它并丢弃那些更改吗？</translation>
    </message>
    <message>
        <source>Discard Unsaved Changes</source>
        <translation>丢弃未保存的更改</translation>
    </message>
    <message>
        <source>Delete the unsaved changes to %1 for good?</source>
        <translation>要永久删除对“%1”的未保存更改吗？</translation>
    </message>
    <message>
        <source>Save the changes to %1 as a scene file? Model files are not changed.</source>
        <translation>要把对 %1 的更改保存为场景文件吗？模型文件不会改变。</translation>
    </message>
    <message>
        <source>Fewer Landmarks</source>
        <translation>标志点变少</translation>
    </message>
    <message>
        <source>%1: landmarks placed in the file: %2; now: %3. Replace the saved landmarks?</source>
        <translation>%1：文件中已放置的标志点：%2；现在：%3。要替换已保存的标志点吗？</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>替换(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Keep the Saved Ones</source>
        <translation>保留已保存的(&amp;K)</translation>
    </message>
</context>
<context>
    <name>unprojector::gui::WrongPointsForm</name>
    <message>
        <source>&amp;Another wrong point</source>
        <translation>再加一个错误的点(&amp;A)</translation>
    </message>
    <message>
        <source>Pixel x, y</source>
        <translation>像素 x, y</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Reason why the input is rejected</source>
        <translation>不能采用的内容</translation>
    </message>
    <message>
        <source>Add another click of the same program to separate similar mistakes. A click in the view fills it</source>
        <translation>同一程序的另一次点击：能确定一次点击定不下来的事。在视图里点击就会填入</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>0.7051 -0.4122 0.0918</source>
        <translation>0.7051 -0.4122 0.0918</translation>
    </message>
    <message>
        <source>Your program&apos;s coordinate</source>
        <translation>您的程序得到的坐标</translation>
    </message>
    <message>
        <source>The wrong coordinate, as the program prints it: 1 2 3, vec3(1, 2, 3), [1. 2. 3.]. Its digits count: 1.50 has two decimals. Rows of px,py,depth,x,y,z can be pasted</source>
        <translation>错误的坐标，按程序打印的样子：1 2 3、vec3(1, 2, 3)、[1. 2. 3.]。位数有意义：1.50 有两位小数。可以粘贴 px,py,depth,x,y,z 的多行</translation>
    </message>
    <message>
        <source>Remove this point</source>
        <translation>去掉这个点</translation>
    </message>
    <message>
        <source>row %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>Ignored in the pasted text, because it is not a number: %1.</source>
        <translation>粘贴的内容中以下各项不是数，没有采用：%1。</translation>
    </message>
    <message>
        <source>Pixel %1 lies outside the view of %2 × %3.</source>
        <translation>像素 %1 在 %2 × %3 的画面之外。</translation>
    </message>
    <message>
        <source>%1 is not a depth: type one number, or leave it empty.</source>
        <translation>%1 不是深度：请键入一个数，或留空。</translation>
    </message>
    <message>
        <source>Correct depth of the pixel, in the view&apos;s depth range. Empty: the mesh&apos;s depth; without a mesh, any depth is possible. A click&apos;s depth is used with all digits</source>
        <translation>此处的正确深度，以视图的深度范围计。留空：取像素下网格的深度；没有网格时任何深度都可以。点击得到的深度按全部位数使用</translation>
    </message>
    <message>
        <source>%1 is not a pixel: %2</source>
        <comment>the field&apos;s text, why</comment>
        <translation>%1 不是像素：%2</translation>
    </message>
    <message>
        <source>its x and y, such as 400.5, 300.5</source>
        <translation>x 和 y，例如 400.5, 300.5</translation>
    </message>
    <message>
        <source>%1 is not a point: %2</source>
        <comment>the field&apos;s text, why</comment>
        <translation>%1 不是点：%2</translation>
    </message>
    <message>
        <source>three coordinates as the program prints them, such as 0.7051 -0.4122 0.0918</source>
        <translation>三个坐标，如程序所打印的样子，例如 0.7051 -0.4122 0.0918</translation>
    </message>
    <message>
        <source>Your click</source>
        <translation>您的点击</translation>
    </message>
    <message>
        <source>What your program printed</source>
        <translation>您的程序打印的结果</translation>
    </message>
    <message>
        <source>x, y, z</source>
        <translation>x, y, z</translation>
    </message>
    <message>
        <source>Click in the view, or type device pixels from the top-left corner; the first pixel&apos;s centre is 0.5, 0.5</source>
        <translation>在视图中点击，或键入从左上角起的设备像素；第一个像素的中心是 0.5, 0.5</translation>
    </message>
    <message>
        <source>of mesh</source>
        <translation>按网格</translation>
    </message>
    <message>
        <source>The first %1 points are used; %2 more is ignored.</source>
        <translation>只看前 %1 个点；另外 %2 个不看。</translation>
    </message>
    <message>
        <source>The first %1 points are used; %2 more are ignored.</source>
        <translation>只看前 %1 个点；另外 %2 个不看。</translation>
    </message>
</context>
</TS>
