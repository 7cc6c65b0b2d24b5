<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>InContext</name>
    <message>
        <source>, {0:.2f} for the stock</source>
        <translation>、材料費 {0:.2f}</translation>
    </message>
    <message>
        <source>"makes" says neither plates nor print</source>
        <translation>"makes" が plates でも print でもありません</translation>
    </message>
    <message>
        <source>210, 21 cm, 3/4 in</source>
        <translation>210, 21 cm, 3/4 in</translation>
    </message>
    <message>
        <source>3, 0.5 cm, 1/8 in</source>
        <translation>3, 0.5 cm, 1/8 in</translation>
    </message>
    <message>
        <source>90, 9 cm, 3/4 in</source>
        <translation>90, 9 cm, 3/4 in</translation>
    </message>
    <message>
        <source>A bookshelf drawn over a photo of a desk, all the way to its plates</source>
        <translation>机の写真の上に描いた本棚。板になるまで</translation>
    </message>
    <message>
        <source>A lens of {0:.0f} mm (equivalent), {1:.0f} mm above the ground; heights are good to {2:.1f} %.</source>
        <translation>焦点距離 {0:.0f} mm（35 mm 換算）、地面から {1:.0f} mm。高さの精度は {2:.1f} % です。</translation>
    </message>
    <message>
        <source>A photo that was not cropped looks towards its middle.</source>
        <translation>切り抜かれていない写真は、その中央を向いています。</translation>
    </message>
    <message>
        <source>A print whose wall lies outside what is drawn</source>
        <translation>描いた形の外側に壁がつく3Dプリント</translation>
    </message>
    <message>
        <source>A print; a marker in the photo gives camera and size</source>
        <translation>3Dプリント。写真のマーカーがカメラと大きさを決めます</translation>
    </message>
    <message>
        <source>A print; traced tiles give the size</source>
        <translation>3Dプリント。なぞったタイルが大きさを決めます</translation>
    </message>
    <message>
        <source>A4 sheet</source>
        <translation>A4 用紙</translation>
    </message>
    <message>
        <source>A5 sheet</source>
        <translation>A5 用紙</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>すべてのファイル</translation>
    </message>
    <message>
        <source>All vertices lie on one line: draw edges in at least two directions.</source>
        <translation>頂点がすべて一直線上です。二方向以上の辺を描いてください。</translation>
    </message>
    <message>
        <source>Angle between the edges {0} and {1}</source>
        <translation>エッジ {0} と {1} の間の角度</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>注釈</translation>
    </message>
    <message>
        <source>As the rectangle, with four equal sides</source>
        <translation>長方形と同じで四辺が等しい</translation>
    </message>
    <message>
        <source>Bank card</source>
        <translation>銀行カード</translation>
    </message>
    <message>
        <source>Between two plates</source>
        <translation>板と板の間隔</translation>
    </message>
    <message>
        <source>Bookshelf</source>
        <translation>本棚</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>箱</translation>
    </message>
    <message>
        <source>By the traced lines</source>
        <translation>なぞった線から</translation>
    </message>
    <message>
        <source>Camera from a rectangle</source>
        <translation>長方形からカメラを求める</translation>
    </message>
    <message>
        <source>Camera of the photo</source>
        <translation>写真のカメラ</translation>
    </message>
    <message>
        <source>Camera of the photo...</source>
        <translation>写真のカメラ...</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Cardboard for a laser, over a photo of a room</source>
        <translation>部屋の写真に描いた、レーザー用の段ボール</translation>
    </message>
    <message>
        <source>Change circle</source>
        <translation>円を変更</translation>
    </message>
    <message>
        <source>Change construction</source>
        <translation>補助線の切り替え</translation>
    </message>
    <message>
        <source>Check fit</source>
        <translation>適合を確認</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>フォルダーを選択</translation>
    </message>
    <message>
        <source>Fix or free angle</source>
        <translation>角度を固定または解除</translation>
    </message>
    <message>
        <source>Fix the angle between two edges that meet, selected in 3D, to type it anew among the model's dimensions; a fixed one follows the drawing again</source>
        <translation>3D で選択した、つながった 2 本のエッジの間の角度を固定し、モデルの寸法として入力し直せるようにします。固定済みの角度は再び図に従います</translation>
    </message>
    <message>
        <source>The angles that are said of this model's corners: two edges and the degrees between them</source>
        <translation>このモデルの角に指定された角度：2 本のエッジとその間の度数</translation>
    </message>
    <message>
        <source>an angle of {0} degrees between {1} and {2} cannot hold beside what else is said</source>
        <translation>{1} と {2} の間の角度 {0} 度は、ほかの指定と両立しません</translation>
    </message>
    <message>
        <source>angle {} {}</source>
        <translation>角度 {} {}</translation>
    </message>
    <message>
        <source>between {} and {} degrees: edges at 0 or 180 degrees lie on one line</source>
        <translation>{} から {} 度の間：0 度や 180 度のエッジは一直線に重なります</translation>
    </message>
    <message>
        <source>the method {}, or freeing that angle</source>
        <translation>方法を {} にするか、その角度を解除してください</translation>
    </message>
    <message>
        <source>lengths of its edges, or diameters</source>
        <translation>そのエッジの長さか、直径</translation>
    </message>
    <message>
        <source>no angle lies between these: select two drawn edges that meet</source>
        <translation>この間に角度はありません：描かれた、つながった 2 本のエッジを選択してください</translation>
    </message>
    <message>
        <source>only right angles stand in a sketch; others are said of the model</source>
        <translation>スケッチに書けるのは直角だけで、ほかの角度はモデルに指定します</translation>
    </message>
    <message>
        <source>say them anew</source>
        <translation>指定し直してください</translation>
    </message>
    <message>
        <source>take one of the others away first</source>
        <translation>先にほかの指定を 1 つ外してください</translation>
    </message>
    <message>
        <source>the model's angles are no JSON</source>
        <translation>モデルの角度が JSON ではありません</translation>
    </message>
    <message>
        <source>the papers' methods know no angle between {0} and {1} but a right one</source>
        <translation>論文の方法では {0} と {1} の間の角度は直角しか扱えません</translation>
    </message>
    <message>
        <source>the side of a surface of revolution takes no angles</source>
        <translation>回転面の側線には角度を指定できません</translation>
    </message>
    <message>
        <source>{}: not a length, the old one stays.</source>
        <translation>{}: 長さではないため、元の値のままです。</translation>
    </message>
    <message>
        <source>Choose a folder for the fit test</source>
        <translation>はめあいテストのフォルダーを選択</translation>
    </message>
    <message>
        <source>Choose a folder for the plates</source>
        <translation>板の保存先フォルダーを選択</translation>
    </message>
    <message>
        <source>Choose a folder for the print</source>
        <translation>印刷用ファイルの保存先を選択</translation>
    </message>
    <message>
        <source>Choose a photo</source>
        <translation>写真を選択</translation>
    </message>
    <message>
        <source>Choose a sketch</source>
        <translation>スケッチを選択</translation>
    </message>
    <message>
        <source>Choose the photo of the place where the new object will live; it is kept inside the document</source>
        <translation>新しい物を置く場所の写真を選択。写真はドキュメントに保存されます</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>選択...</translation>
    </message>
    <message>
        <source>Choosing one sets the values that suit it; they can be edited all the same</source>
        <translation>選ぶと適した値が設定されます。値はあとから編集できます</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>Clearance, overlap and missing millimetres to each thing traced on the photo</source>
        <translation>写真でなぞった各物とのすき間、重なり、不足するミリ数</translation>
    </message>
    <message>
        <source>Click a vertex that touches a face</source>
        <translation>面に接する頂点をクリック</translation>
    </message>
    <message>
        <source>Click a vertex, then the middle of the face that it touches</source>
        <translation>頂点をクリックし、次に接する面の中央をクリック</translation>
    </message>
    <message>
        <source>Click along the side, up to the edge of the top circle; Enter or right click ends</source>
        <translation>側面に沿って上の円の縁までクリック。Enter または右クリックで終了</translation>
    </message>
    <message>
        <source>Click an angle near its corner, or inside a quadrilateral for all four</source>
        <translation>角の近くをクリック、または四角形の内側をクリックで四つすべて</translation>
    </message>
    <message>
        <source>Click an angle that is a right one, or inside a quadrilateral for all four</source>
        <translation>直角の角をクリック、または四角形の内側で四つすべて</translation>
    </message>
    <message>
        <source>Click an edge or a circle and type its size: 210, 21 cm or 3/4 in</source>
        <translation>辺または円をクリックし寸法を入力: 210、21 cm、3/4 in</translation>
    </message>
    <message>
        <source>Click an edge or a circle and type its size (21 cm, 2*18 mm + 5); empty removes it</source>
        <translation>辺または円をクリックし寸法を入力(21 cm、2*18 mm + 5)。空欄で削除</translation>
    </message>
    <message>
        <source>Click edges that are equally long, then Enter or right click</source>
        <translation>同じ長さの辺をクリックし、Enter または右クリック</translation>
    </message>
    <message>
        <source>Click edges that are equally long, then press Enter</source>
        <translation>同じ長さの辺をクリックし Enter</translation>
    </message>
    <message>
        <source>Click edges that are parallel, then Enter or right click</source>
        <translation>平行な辺をクリックし、Enter または右クリック</translation>
    </message>
    <message>
        <source>Click edges that are parallel, then press Enter</source>
        <translation>平行な辺をクリックし Enter</translation>
    </message>
    <message>
        <source>Click in the middle of a face and type how thick its plate is</source>
        <translation>面の中央をクリックし、板の厚さを入力</translation>
    </message>
    <message>
        <source>Click in the middle of a face that stays open, such as the front of a shelf</source>
        <translation>棚の前面など、開けておく面の中央をクリック</translation>
    </message>
    <message>
        <source>Click in the middle of a face that stays open; click again to close it</source>
        <translation>開けておく面の中央をクリック。もう一度クリックで閉じます</translation>
    </message>
    <message>
        <source>Click in the middle of a face, type its thickness and Enter; empty: as the others</source>
        <translation>面の中央をクリックし、厚さを入力して Enter。空欄は他と同じ</translation>
    </message>
    <message>
        <source>Click in the middle of the face that it touches; Esc to give up</source>
        <translation>接する面の中央をクリック。Esc で中止</translation>
    </message>
    <message>
        <source>Click or box to select, drag to move; drop a vertex on another one to merge them</source>
        <translation>クリックか枠で選択、ドラッグで移動。頂点を別の頂点に重ねると結合</translation>
    </message>
    <message>
        <source>Click or box to select; drag vertices, edges, circles and their grips to move them</source>
        <translation>クリックか枠で選択。頂点、辺、円とそのグリップはドラッグで移動</translation>
    </message>
    <message>
        <source>Click the box's left corner on the ground</source>
        <translation>箱の左下の角をクリック</translation>
    </message>
    <message>
        <source>Click the corner above the front one</source>
        <translation>手前の角の真上の角をクリック</translation>
    </message>
    <message>
        <source>Click the corner above the left one</source>
        <translation>左の角の真上の角をクリック</translation>
    </message>
    <message>
        <source>Click the corner above the right one</source>
        <translation>右の角の真上の角をクリック</translation>
    </message>
    <message>
        <source>Click the end of the line; right click stops; Ctrl: no snapping, Shift: crossings</source>
        <translation>線の終点をクリック。右クリックで終了。Ctrl: スナップなし、Shift: 交点</translation>
    </message>
    <message>
        <source>Click the four corners of a printed marker, a sheet of paper or a tile on the ground: it gives the camera and the scale</source>
        <translation>地面に置いた印刷マーカー、紙、タイルの 4 つの角をクリックすると、カメラと縮尺が決まります</translation>
    </message>
    <message>
        <source>Click the four corners of something flat on the ground whose size you know, or press the key again to find the printed marker</source>
        <translation>地面にある大きさの分かる平らな物の 4 つの角をクリックします。もう一度キーを押すと印刷したマーカーを探します</translation>
    </message>
    <message>
        <source>Click the front corner on the ground</source>
        <translation>手前の下の角をクリック</translation>
    </message>
    <message>
        <source>Click the last corner</source>
        <translation>最後の角をクリックします</translation>
    </message>
    <message>
        <source>Click the middle of an edge that the plane halves; Shift-click picks one by one</source>
        <translation>対称面が二等分する辺の中点をクリック。Shift+クリックで一つずつ</translation>
    </message>
    <message>
        <source>Click the middle of an edge that the plane halves; what is hidden behind is added</source>
        <translation>対称面が二等分する辺の中点をクリック。隠れた部分が補われます</translation>
    </message>
    <message>
        <source>Click the next corner; three are left</source>
        <translation>次の角をクリックします（残り 3 つ）</translation>
    </message>
    <message>
        <source>Click the next corner; two are left</source>
        <translation>次の角をクリックします（残り 2 つ）</translation>
    </message>
    <message>
        <source>Click the right corner on the ground</source>
        <translation>右下の角をクリック</translation>
    </message>
    <message>
        <source>Click the seven corners that are seen of a box, such as a book in the photo; as construction it gives the perspective</source>
        <translation>写真の本など、箱の見えている七つの角をクリック。補助線にすると遠近が決まります</translation>
    </message>
    <message>
        <source>Click the start of the line, or drag</source>
        <translation>線の始点をクリック、またはドラッグ</translation>
    </message>
    <message>
        <source>Click the upper corner at the back; X then makes the box construction</source>
        <translation>奥の上の角をクリック。その後 X で補助線になります</translation>
    </message>
    <message>
        <source>Click vertices, edges or the middle of a face that stand on the ground, or box them</source>
        <translation>地面に接する頂点、辺、面の中央をクリック、または枠で囲む</translation>
    </message>
    <message>
        <source>Click what stands on the ground: vertices, edges, the middle of a face; or box them</source>
        <translation>地面に接する頂点、辺、面の中央をクリック、または枠で囲む</translation>
    </message>
    <message>
        <source>Click where the side begins, at the edge of the bottom circle</source>
        <translation>側面の始まり(下の円の縁)をクリック</translation>
    </message>
    <message>
        <source>Construction</source>
        <translation>補助線</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Cover for scissors</source>
        <translation>はさみのカバー</translation>
    </message>
    <message>
        <source>Cup saucer</source>
        <translation>カップの受け皿</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Delete annotation</source>
        <translation>注釈を削除</translation>
    </message>
    <message>
        <source>Delete takes back what is said; a second click, or Enter, changes a size</source>
        <translation>Delete で指定を取り消します。もう一度クリックするか Enter で寸法を変更します</translation>
    </message>
    <message>
        <source>Desk tidy with a step</source>
        <translation>段つきの卓上整理箱</translation>
    </message>
    <message>
        <source>Desktop organizer</source>
        <translation>卓上整理箱</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Diameter of circle {}</source>
        <translation>円 {} の直径</translation>
    </message>
    <message>
        <source>Diameter of the round cutter, for the corner relief</source>
        <translation>角の逃げのための刃の直径</translation>
    </message>
    <message>
        <source>Does it fit?</source>
        <translation>収まりますか？</translation>
    </message>
    <message>
        <source>Drag a box around a horizontal circle as it is seen: its ellipse fills the box</source>
        <translation>写真に見える水平な円を枠で囲むようにドラッグ。楕円が枠いっぱいに入ります</translation>
    </message>
    <message>
        <source>Drag a box around a horizontal circle as it is seen; pull its four grips afterwards</source>
        <translation>見えている水平な円を枠で囲む。後で四つのグリップで調整</translation>
    </message>
    <message>
        <source>Drag a corner to move it, Delete forgets the camera, four clicks elsewhere begin anew</source>
        <translation>角をドラッグすると動きます。Delete でカメラを忘れ、別の場所の 4 クリックでやり直します</translation>
    </message>
    <message>
        <source>Drag from one corner of the rectangle to the opposite one; move corners afterwards</source>
        <translation>角から対角へドラッグ。角は後で動かせます</translation>
    </message>
    <message>
        <source>Drag the bottom circle of the new object, or click one that is drawn</source>
        <translation>新しい物の下の円をドラッグ、または描いた円をクリック</translation>
    </message>
    <message>
        <source>Drag the circle where it stands on the ground or table, or click one that is drawn</source>
        <translation>地面や机に接する円をドラッグ、または描いた円をクリック</translation>
    </message>
    <message>
        <source>Drag the rectangle: it lies level; press the key again to turn it upright</source>
        <translation>四角形をドラッグ(水平)。もう一度キーを押すと垂直になります</translation>
    </message>
    <message>
        <source>Drag the rectangle: it stands upright; press the key again for any corners</source>
        <translation>四角形をドラッグ(垂直)。もう一度キーを押すと角が自由になります</translation>
    </message>
    <message>
        <source>Drag the rectangle: it stands upright; press the key again to turn it</source>
        <translation>四角形をドラッグ(垂直)。もう一度キーを押すと向きが変わります</translation>
    </message>
    <message>
        <source>Drag the top circle of the new object, or click one that is drawn</source>
        <translation>新しい物の上の円をドラッグ、または描いた円をクリック</translation>
    </message>
    <message>
        <source>Drag to move, Shift-click to add, Delete; type a length; right click shows more</source>
        <translation>ドラッグで移動、Delete で削除。Shift+クリックで追加。数字で長さを入力。右クリックでメニュー</translation>
    </message>
    <message>
        <source>Draw a new object over one photo, get a 3D shape and plates to cut</source>
        <translation>写真の上に新しい物を描くと、3D の形と切り出す板になります</translation>
    </message>
    <message>
        <source>Draw box</source>
        <translation>箱を描く</translation>
    </message>
    <message>
        <source>Draw circle</source>
        <translation>円を描く</translation>
    </message>
    <message>
        <source>Draw line</source>
        <translation>線を描く</translation>
    </message>
    <message>
        <source>Draw rectangle</source>
        <translation>長方形を描く</translation>
    </message>
    <message>
        <source>Draw side</source>
        <translation>側面を描く</translation>
    </message>
    <message>
        <source>Draw square</source>
        <translation>正方形を描く</translation>
    </message>
    <message>
        <source>Draw straight edges, click after click or one with each drag</source>
        <translation>直線の辺を描く。クリックで連続、またはドラッグで一本ずつ</translation>
    </message>
    <message>
        <source>Draw the ground, bottom and top circle, then the side from bottom to top</source>
        <translation>地面、下、上の円を描き、側面を下から上へ</translation>
    </message>
    <message>
        <source>Draw the new object over the photo: press L for lines, R for rectangles</source>
        <translation>写真の上に新しい物を描きます。L で線、R で長方形</translation>
    </message>
    <message>
        <source>Drawing of the plates</source>
        <translation>板の図面</translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation>例(&amp;X)</translation>
    </message>
    <message>
        <source>Edit sketch</source>
        <translation>スケッチを編集</translation>
    </message>
    <message>
        <source>Equal length</source>
        <translation>等しい長さ</translation>
    </message>
    <message>
        <source>Equal lengths</source>
        <translation>等しい長さ</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>エクスポート</translation>
    </message>
    <message>
        <source>Export a PDF in true size too</source>
        <translation>原寸の PDF も書き出す</translation>
    </message>
    <message>
        <source>Export a fit test with these settings too</source>
        <translation>この設定のはめあい試験片も書き出す</translation>
    </message>
    <message>
        <source>Export plates</source>
        <translation>板のエクスポート</translation>
    </message>
    <message>
        <source>Export plates...</source>
        <translation>板を書き出す…</translation>
    </message>
    <message>
        <source>Export print</source>
        <translation>印刷用のエクスポート</translation>
    </message>
    <message>
        <source>Export print...</source>
        <translation>印刷用に書き出す…</translation>
    </message>
    <message>
        <source>Export the parts list too</source>
        <translation>部品表も書き出す</translation>
    </message>
    <message>
        <source>Faces are known once the sketch is solved: the line below says what is missing</source>
        <translation>面はスケッチが解けるとわかります。足りないものは下の行に表示されます</translation>
    </message>
    <message>
        <source>Find camera</source>
        <translation>カメラを求める</translation>
    </message>
    <message>
        <source>Finished size of the plate</source>
        <translation>板の仕上がり寸法</translation>
    </message>
    <message>
        <source>Fit check</source>
        <translation>適合の確認</translation>
    </message>
    <message>
        <source>Fit test</source>
        <translation>はめ合い試験片</translation>
    </message>
    <message>
        <source>Fix or free size</source>
        <translation>寸法を固定または解除</translation>
    </message>
    <message>
        <source>Fix size</source>
        <translation>寸法を固定</translation>
    </message>
    <message>
        <source>Fix the length of edges, the diameter of circles or the height of vertices selected in 3D, to type it anew among the model's dimensions; fixed ones follow the drawing again</source>
        <translation>3D で選択したエッジの長さ、円の直径、頂点の高さを固定し、モデルの寸法で入力できるようにします。固定済みのものは再び図に従います</translation>
    </message>
    <message>
        <source>Flat plate</source>
        <translation>平らな板</translation>
    </message>
    <message>
        <source>Flat plates</source>
        <translation>平らな板</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>焦点距離</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Follows from the others</source>
        <translation>他から決まります</translation>
    </message>
    <message>
        <source>For the parts list; 0 for unknown</source>
        <translation>部品表用。0 は不明</translation>
    </message>
    <message>
        <source>For the time, in mm/s</source>
        <translation>時間の計算用、mm/s</translation>
    </message>
    <message>
        <source>Forget camera</source>
        <translation>カメラを忘れる</translation>
    </message>
    <message>
        <source>Free border of a sheet</source>
        <translation>板材の余白</translation>
    </message>
    <message>
        <source>Free size</source>
        <translation>寸法を解除</translation>
    </message>
    <message>
        <source>Full width that the beam removes; changes the cut paths only, never the plates</source>
        <translation>レーザーが削る全幅。切断線だけが変わり、板は変わりません</translation>
    </message>
    <message>
        <source>Grid: {}</source>
        <translation>グリッド: {}</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Ground grid</source>
        <translation>地面のグリッド</translation>
    </message>
    <message>
        <source>Have the pen stick to straight edges and corners that are seen in the photo</source>
        <translation>写真に写っている直線のエッジと角にペンを吸着させます</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height above the ground of {}</source>
        <translation>{} の地面からの高さ</translation>
    </message>
    <message>
        <source>Heights are good to {} % only: have the rectangle larger in the photo.</source>
        <translation>高さの精度は {} % しかありません。長方形を大きく写してください。</translation>
    </message>
    <message>
        <source>How far the triangles of exported files may leave curved surfaces</source>
        <translation>書き出す三角形と曲面の許容差</translation>
    </message>
    <message>
        <source>How many plates there are</source>
        <translation>板の枚数</translation>
    </message>
    <message>
        <source>How much wider a slot is than the finger that goes into it</source>
        <translation>溝がほぞより広い量</translation>
    </message>
    <message>
        <source>How strong the photo is: fade it to see the lines</source>
        <translation>写真の濃さ。薄くすると線が見やすくなります</translation>
    </message>
    <message>
        <source>How the last recompute ended</source>
        <translation>最後の再計算の結果</translation>
    </message>
    <message>
        <source>How the plates are joined at each edge</source>
        <translation>各辺での板のつなぎ方</translation>
    </message>
    <message>
        <source>How the sketch is lifted. The methods of the papers are slow and less exact: they are there to compare with</source>
        <translation>スケッチを立体にする方法です。論文の方法は遅く、精度も劣ります。比較のためにあります</translation>
    </message>
    <message>
        <source>How wide fingers should be</source>
        <translation>ほぞの幅</translation>
    </message>
    <message>
        <source>If {} and {} are square at {}, saying so would help most.</source>
        <translation>{} と {} が {} で直角なら、それを指定するのが最も役に立ちます。</translation>
    </message>
    <message>
        <source>Import sketch</source>
        <translation>スケッチを読み込む</translation>
    </message>
    <message>
        <source>Import sketch...</source>
        <translation>スケッチを読み込む…</translation>
    </message>
    <message>
        <source>In which order the plates go together</source>
        <translation>板を組み立てる順序</translation>
    </message>
    <message>
        <source>Include face</source>
        <translation>面を含める</translation>
    </message>
    <message>
        <source>Install</source>
        <translation>インストール</translation>
    </message>
    <message>
        <source>Installing ...</source>
        <translation>インストール中…</translation>
    </message>
    <message>
        <source>It is</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>It looked towards</source>
        <translation>向いていた点</translation>
    </message>
    <message>
        <source>Its id</source>
        <translation>その ID</translation>
    </message>
    <message>
        <source>Its sizes are unsure: mark more, give a length, or trace something real in the photo.</source>
        <translation>寸法は不確かです。指定を増やす、長さを与える、または写真の実物をなぞってください。</translation>
    </message>
    <message>
        <source>{} cannot hold with the rest: try removing them.</source>
        <translation>{} は残りの指定と両立しません。これらを外してみてください。</translation>
    </message>
    <message>
        <source>Only just enough is said, and other shapes may fit as well: mark more.</source>
        <translation>指定はちょうど足りるだけで、ほかの形も同じくらい合うかもしれません。もっと指定してください。</translation>
    </message>
    <message>
        <source>Lay the sheet flat on the ground where the new object will stand, and take the photo.</source>
        <translation>新しい物を置く場所の地面にこの紙を平らに置き、写真を撮ってください。</translation>
    </message>
    <message>
        <source>Layers and colours in files: a shop's or program's name, or your own .json file</source>
        <translation>ファイルのレイヤーと色。業者やソフトの名前、または自分の .json</translation>
    </message>
    <message>
        <source>Leave face out</source>
        <translation>面を省く</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>省く</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Length, diameter</source>
        <translation>長さ・直径</translation>
    </message>
    <message>
        <source>Let go, or click, at the opposite corner of the box; Esc to give up</source>
        <translation>枠の反対側の角で放すかクリック。Esc で中止</translation>
    </message>
    <message>
        <source>Let go, or click, at the opposite corner; Esc to give up</source>
        <translation>反対側の角で放すかクリック。Esc で中止</translation>
    </message>
    <message>
        <source>Letter sheet</source>
        <translation>レター用紙</translation>
    </message>
    <message>
        <source>Lift to 3D</source>
        <translation>3D に起こす</translation>
    </message>
    <message>
        <source>Lifted model</source>
        <translation>起こしたモデル</translation>
    </message>
    <message>
        <source>Lifting by the method {} ...</source>
        <translation>{} の方法で立体にしています...</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>線</translation>
    </message>
    <message>
        <source>Lines on straight things bend by up to {} px ({}): the lens distorts, by {} % at the photo's corners: straighten the photo.</source>
        <translation>まっすぐな物の線が最大 {} px 曲がっています（{}）。レンズの歪みは写真の隅で {} % です。写真の歪みを補正してください。</translation>
    </message>
    <message>
        <source>Long edges in the photo bend by up to {} px: the lens distorts, by {} % at the photo's corners: straighten the photo.</source>
        <translation>写真の中の長い縁が最大 {} px 曲がっています。レンズの歪みは写真の隅で {} % です。写真の歪みを補正してください。</translation>
    </message>
    <message>
        <source>Look at the 3D model from where the photo was taken, with the photo behind it; once more brings the old view back</source>
        <translation>写真を撮った位置から、写真を背景に 3D モデルを見る。もう一度で元の表示に戻ります</translation>
    </message>
    <message>
        <source>Loose and thin parts</source>
        <translation>外れやすい所と薄い所</translation>
    </message>
    <message>
        <source>Loose or thin</source>
        <translation>外れやすい・薄い</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>機械</translation>
    </message>
    <message>
        <source>Make a TechDraw page of the plates with their main sizes and a parts list</source>
        <translation>板の主な寸法と部品表をもつ TechDraw ページを作ります</translation>
    </message>
    <message>
        <source>Make a small comb with notches of different play and a tab, with the settings of the plates: cut it first; selected, it is written by Export plates</source>
        <translation>板と同じ設定で、遊びの異なる切り欠きの小さな櫛とほぞを作ります。最初に切ってください。選択すると「板を書き出す」で書き出されます</translation>
    </message>
    <message>
        <source>Make finger-jointed plates of the sketch; thickness, fingers, play and kerf are properties of the result</source>
        <translation>スケッチから組み継ぎの板を作成。厚さ、ほぞ、あそび、切り幅は結果のプロパティです</translation>
    </message>
    <message>
        <source>Make fit test</source>
        <translation>はめ合い試験片を作成</translation>
    </message>
    <message>
        <source>Make one hollow solid of the sketch, for a 3D printer; faces left out are openings. The first time takes some seconds</source>
        <translation>3D プリンター用の中空の立体を作成。省いた面は開口になります。初回は数秒かかります</translation>
    </message>
    <message>
        <source>Make plates</source>
        <translation>板を作成</translation>
    </message>
    <message>
        <source>Make shelled solid</source>
        <translation>中空の立体を作成</translation>
    </message>
    <message>
        <source>Make the 3D model of the sketch; it follows every change of the sketch</source>
        <translation>スケッチの 3D モデルを作成。スケッチの変更に追従します</translation>
    </message>
    <message>
        <source>Make the selected edges and circles construction: traced on what is in the photo, no part of the object; or part of it again</source>
        <translation>選択した辺と円を補助線にする(写真の実物をなぞったもので、物の一部ではない)。または元に戻す</translation>
    </message>
    <message>
        <source>Mark equal length</source>
        <translation>等しい長さを指定</translation>
    </message>
    <message>
        <source>Mark ground</source>
        <translation>地面を指定</translation>
    </message>
    <message>
        <source>Mark on face</source>
        <translation>面上を指定</translation>
    </message>
    <message>
        <source>Mark parallel</source>
        <translation>平行を指定</translation>
    </message>
    <message>
        <source>Mark right angle</source>
        <translation>直角を指定</translation>
    </message>
    <message>
        <source>Mark symmetry plane</source>
        <translation>対称面を指定</translation>
    </message>
    <message>
        <source>Marker: the black square measures {}</source>
        <translation>マーカー：黒い正方形の一辺は {}</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Merge vertices</source>
        <translation>頂点を結合</translation>
    </message>
    <message>
        <source>Modeling in &amp;Context</source>
        <translation>Modeling in &amp;Context</translation>
    </message>
    <message>
        <source>Modeling in Context</source>
        <translation>Modeling in Context</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Move vertex</source>
        <translation>頂点を移動</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>New sketch from a photo</source>
        <translation>写真から新しいスケッチ</translation>
    </message>
    <message>
        <source>New sketch from a photo...</source>
        <translation>写真から新しいスケッチ…</translation>
    </message>
    <message>
        <source>New sketch from the clipboard</source>
        <translation>クリップボードから新しいスケッチ</translation>
    </message>
    <message>
        <source>No 3D shape fits this drawing; check the annotations against it.</source>
        <translation>この図に合う 3D の形がありません。注釈を図と見比べてください。</translation>
    </message>
    <message>
        <source>Several traced lines are off: where the photo was cropped, use the whole photo, or say where it looked in the photo's camera.</source>
        <translation>なぞった線のいくつかがずれています。写真を切り抜いた場合は、元の写真全体を使うか、写真のカメラで視線の中心を指定してください。</translation>
    </message>
    <message>
        <source>The photo is blurred there, edges are {} px wide: sizes are less sure; take it with a steady hand, or in more light.</source>
        <translation>写真のその部分がぶれています(エッジの幅 {} px)。寸法の確かさが下がります。カメラを固定するか、明るい場所で撮影してください。</translation>
    </message>
    <message>
        <source>No camera takes photos of {} x {} px: where this one was cropped, sizes may be off by some percent: use the whole photo, or say where it looked in the photo's camera.</source>
        <translation>{} x {} px の写真を撮るカメラはありません。切り抜かれた写真なら寸法が数パーセントずれることがあります。元の写真を使うか、写真のカメラで視線の中心を指定してください。</translation>
    </message>
    <message>
        <source>No face is known yet: close a loop of edges with right angles, or list faces</source>
        <translation>面がまだありません。直角のある辺の輪を閉じてください</translation>
    </message>
    <message>
        <source>No faces were looked for: {}.</source>
        <translation>面は探しませんでした: {}。</translation>
    </message>
    <message>
        <source>No hollow at all</source>
        <translation>中空にしない</translation>
    </message>
    <message>
        <source>No shape was found in which all annotations hold: mark more right angles, parallels or ground vertices, or check {}.</source>
        <translation>すべての注釈が成り立つ形が見つかりません。直角、平行、地面を増やすか、{} を確認してください。</translation>
    </message>
    <message>
        <source>No straight edges are seen between the corners, which are taken as they are: place them well.</source>
        <translation>角の間に直線の縁が見えないので、角はそのまま使います。正確に置いてください。</translation>
    </message>
    <message>
        <source>No straight thing is seen: draw lines along some, near the photo's borders, and make them construction (X).</source>
        <translation>まっすぐな物が見つかりません。写真の端に近いまっすぐな物に沿って線を引き、補助線（X）にしてください。</translation>
    </message>
    <message>
        <source>{} cannot hold with what is said of the circles and the rest of the side: take one of these away.</source>
        <translation>{} は、円や側面の残りについての注釈と両立しません。どれかを取り除いてください。</translation>
    </message>
    <message>
        <source>Not flat enough for a face: {}, {} mm off: mark right angles or parallels there, or take it for a face.</source>
        <translation>面にするには平らさが足りません：{}（{} mm のずれ）。そこに直角か平行の注釈を付けるか、面として受け入れてください。</translation>
    </message>
    <message>
        <source>Where {} is flat, taking it for a face would help.</source>
        <translation>{} が平らなら、面として受け入れると決まります。</translation>
    </message>
    <message>
        <source>No face was found for {}: choose another one.</source>
        <translation>{} の面が見つかりません。別の面を選んでください。</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>後で</translation>
    </message>
    <message>
        <source>Nothing is traced on the photo to fit to. Draw what is there with the line, box or circle tool and press X to make it construction.</source>
        <translation>合わせる物が写真でなぞられていません。線・箱・円のツールで描き、X キーで補助線にしてください。</translation>
    </message>
    <message>
        <source>Of new plates</source>
        <translation>新しい板</translation>
    </message>
    <message>
        <source>Of new shelled solids</source>
        <translation>新しいシェル</translation>
    </message>
    <message>
        <source>Of the object alone</source>
        <translation>作る物だけの重心</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>ずれ</translation>
    </message>
    <message>
        <source>On a face</source>
        <translation>面の上</translation>
    </message>
    <message>
        <source>On face</source>
        <translation>面上</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>地面の上</translation>
    </message>
    <message>
        <source>One drag makes four edges and four right angles, in perspective once that is known; move the corners afterwards</source>
        <translation>一回のドラッグで四辺と四つの直角。遠近がわかればそれに従います。角は後で動かせます</translation>
    </message>
    <message>
        <source>Open a .sketch.json file; its photo is taken from beside it</source>
        <translation>.sketch.json ファイルを開く。写真は同じ場所から読みます</translation>
    </message>
    <message>
        <source>Open the bookshelf example</source>
        <translation>本棚の例を開く</translation>
    </message>
    <message>
        <source>Or in a terminal:</source>
        <translation>または端末で:</translation>
    </message>
    <message>
        <source>Other joints at some edges, such as e5=butt or f1:f2=finger,finger=8,owner=f1; kinds: auto, finger, butt, half_lap, tab_slot, none</source>
        <translation>辺ごとの別の継手(例: e5=butt、f1:f2=finger,finger=8,owner=f1)。種類: auto, finger, butt, half_lap, tab_slot, none</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;SVG (*.svg)</source>
        <translation>PDF (*.pdf);;SVG (*.svg)</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>平行</translation>
    </message>
    <message>
        <source>Parameter numbers</source>
        <translation>パラメーター数</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>部品表</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>写真</translation>
    </message>
    <message>
        <source>Photo sketch</source>
        <translation>写真スケッチ</translation>
    </message>
    <message>
        <source>Photo's middle</source>
        <translation>写真の中央</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>写真</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>板</translation>
    </message>
    <message>
        <source>Plate {}</source>
        <translation>板 {}</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>板</translation>
    </message>
    <message>
        <source>Plates for a laser, over a cropped photo</source>
        <translation>切り抜いた写真に描いた、レーザー用の板</translation>
    </message>
    <message>
        <source>Plates for a laser, over a photo of stationery</source>
        <translation>文房具の写真に描いた、レーザー用の板</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>Presets of your own, as .json files like ours, belong in {}</source>
        <translation>自分のプリセットは、同じ形の .json ファイルとして {} に置きます</translation>
    </message>
    <message>
        <source>Print marker</source>
        <translation>マーカーを印刷</translation>
    </message>
    <message>
        <source>Print marker...</source>
        <translation>マーカーを印刷...</translation>
    </message>
    <message>
        <source>Printed marker</source>
        <translation>印刷したマーカー</translation>
    </message>
    <message>
        <source>Put another photo under the sketch; a photo can also be dropped on it or pasted</source>
        <translation>スケッチの下の写真を差し替え。ドロップや貼り付けもできます</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>Rectangle and drawing do not agree: check both.</source>
        <translation>長方形と図が合いません。両方を確かめてください。</translation>
    </message>
    <message>
        <source>Refine by the drawing</source>
        <translation>図で精度を上げる</translation>
    </message>
    <message>
        <source>Refine camera</source>
        <translation>カメラの精度を上げる</translation>
    </message>
    <message>
        <source>Remove on face</source>
        <translation>面上の指定を解除</translation>
    </message>
    <message>
        <source>Remove right angle</source>
        <translation>直角を解除</translation>
    </message>
    <message>
        <source>Remove symmetry plane</source>
        <translation>対称面を解除</translation>
    </message>
    <message>
        <source>Replace photo</source>
        <translation>写真を差し替え</translation>
    </message>
    <message>
        <source>Replace photo...</source>
        <translation>写真を差し替える…</translation>
    </message>
    <message>
        <source>Right angle</source>
        <translation>直角</translation>
    </message>
    <message>
        <source>Room for a round cutter in corners that look inwards; a laser needs none</source>
        <translation>内側の角に丸い刃のための逃げ。レーザーには不要</translation>
    </message>
    <message>
        <source>Say where the middle of the whole photo was; or trace a box in the photo (key B, then X), and its lines tell it.</source>
        <translation>元の写真の中央がどこだったかを入力してください。または写真の箱をなぞる（B キー、次に X）と、その線から分かります。</translation>
    </message>
    <message>
        <source>See and say what is known of the camera: its focal length, and in a cropped photo where it looked</source>
        <translation>カメラについて分かっていることを見て、入力します。焦点距離と、切り抜いた写真では向いていた点です</translation>
    </message>
    <message>
        <source>Seen from straight above, heights are hardly to be told: take the photo from lower down.</source>
        <translation>真上からは高さがほとんど分かりません。もっと低い位置から撮ってください。</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Set diameter</source>
        <translation>直径を設定</translation>
    </message>
    <message>
        <source>Set length</source>
        <translation>長さを設定</translation>
    </message>
    <message>
        <source>Set thickness</source>
        <translation>厚さを設定</translation>
    </message>
    <message>
        <source>Shelled solid</source>
        <translation>中空の立体</translation>
    </message>
    <message>
        <source>Shift-click more middles, then Enter or right click; Esc to give up</source>
        <translation>Shift+クリックで中点を追加し、Enter または右クリック。Esc で中止</translation>
    </message>
    <message>
        <source>Show a grid on the ground in the photo's perspective, once that is known; the pen sticks to its lines and crossings</source>
        <translation>写真の遠近法がわかると地面にグリッドを表示します。ペンは線と交点に吸着します</translation>
    </message>
    <message>
        <source>Show at each vertex how many of its three coordinates are still its own: what is said of the sketch gives the others</source>
        <translation>各頂点に、三つの座標のうち独自に残る数を表示。残りは注釈から決まります</translation>
    </message>
    <message>
        <source>Show the photo and the sketch over it; drag a vertex, and the model follows</source>
        <translation>写真とスケッチを表示。頂点をドラッグするとモデルが追従します</translation>
    </message>
    <message>
        <source>Show the plates apart, the way they are put together</source>
        <translation>組み立てる向きに板を離して表示</translation>
    </message>
    <message>
        <source>Show the sheets and the length of the cuts, and write DXF, SVG, PDF, STEP and lists; where a fit test is selected, write that</source>
        <translation>シート上の配置と切断の長さを表示し、DXF、SVG、PDF、STEP と一覧を書き出します。はめあいテストを選択しているときはそれを書き出します</translation>
    </message>
    <message>
        <source>Show the whole photo (F)</source>
        <translation>写真全体を表示 (F)</translation>
    </message>
    <message>
        <source>Side of the black square</source>
        <translation>黒い正方形の一辺</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>寸法</translation>
    </message>
    <message>
        <source>Size of the stock</source>
        <translation>板材の大きさ</translation>
    </message>
    <message>
        <source>Size of the stock; 0 takes the smallest usual sheet that holds every plate</source>
        <translation>板材の大きさ。0 なら全部の板が入る最小の規格</translation>
    </message>
    <message>
        <source>Sketch &amp;tools</source>
        <translation>スケッチツール(&amp;T)</translation>
    </message>
    <message>
        <source>Sketch tools</source>
        <translation>スケッチツール</translation>
    </message>
    <message>
        <source>Sketches (*.sketch.json);;All files (*)</source>
        <translation>スケッチ (*.sketch.json);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Solved without {}.</source>
        <translation>{} なしで解きました。</translation>
    </message>
    <message>
        <source>Correct {}, or take it away.</source>
        <translation>{} を直すか、取り除いてください。</translation>
    </message>
    <message>
        <source>Solved, but a second shape, with near and far exchanged, fits as well: mark what stands on the ground, or ask for the twin.</source>
        <translation>解けましたが、遠近を入れ替えた別の形も同じくらい合います。地面にある点を指定するか、もう一方の形を求めてください。</translation>
    </message>
    <message>
        <source>Stopped before the end: this is as far as it came.</source>
        <translation>途中で止めました。ここまでの結果です。</translation>
    </message>
    <message>
        <source>Solved, but seen from below: mark what stands on the ground.</source>
        <translation>解けましたが下から見ています。地面にあるものを指定してください。</translation>
    </message>
    <message>
        <source>Nothing is said to be square or parallel: begin with right angles at {}.</source>
        <translation>直角も平行も指定されていません。まず {} に直角を付けてください。</translation>
    </message>
    <message>
        <source>Solved, but seen from below: check the ground vertices.</source>
        <translation>解けましたが下から見ています。地面の頂点を確認してください。</translation>
    </message>
    <message>
        <source>The drawing is missed by {} px.</source>
        <translation>線画と {} px ずれています。</translation>
    </message>
    <message>
        <source>Solved, but the drawing is missed by {} px: check the annotations against it.</source>
        <translation>解けましたが、線画と {} px ずれています。注釈を線画と見比べてください。</translation>
    </message>
    <message>
        <source>Solved, but the drawing is missed by {} px: check {}.</source>
        <translation>解けましたが、線画と {} px ずれています。{} を確かめてください。</translation>
    </message>
    <message>
        <source>Solved, but {} contradicts the drawing, which is missed by {} px.</source>
        <translation>解けましたが、{} は線画と矛盾し、線画と {} px ずれています。</translation>
    </message>
    <message>
        <source>Solved, but {} contradicts the drawing: with it the drawing is missed by {} px, without it by {} px.</source>
        <translation>解けましたが {} は図と矛盾します。あると {} px、ないと {} px 外れます。</translation>
    </message>
    <message>
        <source>Solved, with a usual focal length assumed: the drawing does not tell it.</source>
        <translation>標準的な焦点距離を仮定して解けました(図からは決まりません)。</translation>
    </message>
    <message>
        <source>Solved, with what is drawn nearly square taken to be square: mark right angles where it is.</source>
        <translation>解けました。ほぼ直角に描かれた所は直角とみなしました。直角の所に直角を付けてください。</translation>
    </message>
    <message>
        <source>Solved.</source>
        <translation>解けました。</translation>
    </message>
    <message>
        <source>Something else</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>正方形</translation>
    </message>
    <message>
        <source>Stick to the photo's edges</source>
        <translation>写真のエッジに吸着</translation>
    </message>
    <message>
        <source>Stopped; nothing is installed.</source>
        <translation>中止しました。何もインストールされていません。</translation>
    </message>
    <message>
        <source>Storage box for a chair</source>
        <translation>椅子の下の収納箱</translation>
    </message>
    <message>
        <source>Straighten photo</source>
        <translation>写真の歪みを補正</translation>
    </message>
    <message>
        <source>Surface of revolution</source>
        <translation>回転体</translation>
    </message>
    <message>
        <source>Symmetry plane</source>
        <translation>対称面</translation>
    </message>
    <message>
        <source>Take the suggestion (Y)</source>
        <translation>提案を採用 (Y)</translation>
    </message>
    <message>
        <source>Take all {} suggestions (Y)</source>
        <translation>提案 {} 件をすべて採用 (Y)</translation>
    </message>
    <message>
        <source>Take suggestions</source>
        <translation>提案を採用</translation>
    </message>
    <message>
        <source>Take the lens's distortion out of the photo: its long edges, and lines traced on straight things as construction, tell how it bends them</source>
        <translation>レンズの歪みを写真から取り除きます。写真の中の長い縁と、まっすぐな物を補助線としてなぞった線から、曲がり方が分かります</translation>
    </message>
    <message>
        <source>Take the picture, or the picture file, that was copied last as the photo</source>
        <translation>最後にコピーした画像または画像ファイルを写真にする</translation>
    </message>
    <message>
        <source>Teapot lid</source>
        <translation>急須のふた</translation>
    </message>
    <message>
        <source>Test the plates or the solid against the things traced on the photo, and whether they stand: clearance, overlaps in red, centre of mass, loose and thin parts</source>
        <translation>板や立体を写真でなぞった物と照らし合わせ、立つかどうかも確認します：すき間、重なり（赤）、重心、外れやすい所や薄い所</translation>
    </message>
    <message>
        <source>That did not work:</source>
        <translation>うまくいきませんでした:</translation>
    </message>
    <message>
        <source>The corners are {} px off any rectangle of this size: check the size, that it lies flat, and that the photo was not cropped.</source>
        <translation>四隅はこの大きさのどの長方形からも {} px ずれています。大きさ、平らに置かれているか、写真が切り抜かれていないかを確かめてください。</translation>
    </message>
    <message>
        <source>The corners do not tell which side is the longer one: check the grid on the ground, or keep the photo's EXIF data.</source>
        <translation>角だけではどちらが長辺か決まりません。地面のグリッドを確かめるか、写真の EXIF データを残してください。</translation>
    </message>
    <message>
        <source>The corners do not tell which way the ground leans: have the rectangle larger in the photo, and check the grid on the ground.</source>
        <translation>角だけでは地面の傾きの向きが決まりません。長方形を大きく写し、地面のグリッドを確かめてください。</translation>
    </message>
    <message>
        <source>The drawing and the annotations are too far apart: check the annotations.</source>
        <translation>図と注釈が離れすぎています。注釈を確認してください。</translation>
    </message>
    <message>
        <source>The drawing does not tell the focal length: a usual one is assumed.</source>
        <translation>線画からは焦点距離が分からないため、一般的な値を仮定しました。</translation>
    </message>
    <message>
        <source>The focal length was {0:.1f} mm and is {1:.1f} mm.</source>
        <translation>焦点距離は {0:.1f} mm から {1:.1f} mm になりました。</translation>
    </message>
    <message>
        <source>The given lengths put the camera {} mm ({} %) off its known height: check the length, the camera, and what stands on the ground.</source>
        <translation>指定した長さによると、カメラは既知の高さから {} mm ({} %) ずれます。長さ、カメラ、地面にあるものを確かめてください。</translation>
    </message>
    <message>
        <source>The grid shows once the sketch is solved</source>
        <translation>スケッチが解けるとグリッドが表示されます</translation>
    </message>
    <message>
        <source>The model that is hollowed out</source>
        <translation>中空にするモデル</translation>
    </message>
    <message>
        <source>The model that plates are made of</source>
        <translation>板のもとになるモデル</translation>
    </message>
    <message>
        <source>The photo, kept inside the document</source>
        <translation>ドキュメントに保存された写真</translation>
    </message>
    <message>
        <source>The plates or the solid that are checked</source>
        <translation>確認する板または立体</translation>
    </message>
    <message>
        <source>The plates that it is one of</source>
        <translation>これが属する板の組</translation>
    </message>
    <message>
        <source>The plates whose settings it tries</source>
        <translation>設定を試す板</translation>
    </message>
    <message>
        <source>The play of each notch in mm, from left to right; it is engraved beside it</source>
        <translation>左から順に各切り欠きの遊び（mm）。横に彫刻されます</translation>
    </message>
    <message>
        <source>The polygon on which it stands</source>
        <translation>接地している多角形</translation>
    </message>
    <message>
        <source>The rectangle is seen too square-on to tell the focal length, which is good to {} % only: take the photo from lower down, or keep its EXIF data.</source>
        <translation>長方形がほぼ真上から写っているため焦点距離が決まりません（精度 {} %）。もっと低い位置から撮るか、EXIF データを残してください。</translation>
    </message>
    <message>
        <source>The rectangle tells {0:.0f} mm.</source>
        <translation>長方形によると {0:.0f} mm です。</translation>
    </message>
    <message>
        <source>The sketch has no edges: draw the object's edges over the photo.</source>
        <translation>スケッチに辺がありません。写真の上に物の辺を描いてください。</translation>
    </message>
    <message>
        <source>The sketch that is lifted to 3D</source>
        <translation>3D に起こすスケッチ</translation>
    </message>
    <message>
        <source>The traced line {} is {} px ({} degrees) off the perspective of the rest: check it.</source>
        <translation>なぞった線 {} は他の線の遠近から {} px（{} 度）ずれています。確かめてください。</translation>
    </message>
    <message>
        <source>Straight lines bend by {:.1f} px at most: there is nothing to straighten.</source>
        <translation>まっすぐな線の曲がりは最大 {:.1f} px です。補正は必要ありません。</translation>
    </message>
    <message>
        <source>The traced lines meet as in a cropped photo: it was taken towards {} px, not {} px: say so in the photo's camera, or use the whole photo.</source>
        <translation>なぞった線は切り抜いた写真のように交わります。{} px を向いており、{} px ではありません。写真のカメラで入力するか、切り抜く前の写真を使ってください。</translation>
    </message>
    <message>
        <source>The traced lines say: towards {0:.0f}, {1:.0f} px, good to {2:.0f} px.</source>
        <translation>なぞった線によると {0:.0f}, {1:.0f} px を向いています（誤差 {2:.0f} px）。</translation>
    </message>
    <message>
        <source>The traced lines {} are too nearly parallel in the photo to tell where they meet: trace others further apart, or use a marker.</source>
        <translation>なぞった線 {} は写真の中でほぼ平行なので、どこで交わるか分かりません。もっと離れた線をなぞるか、マーカーを使ってください。</translation>
    </message>
    <message>
        <source>There is no photo: choose one first.</source>
        <translation>写真がありません。先に選んでください。</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>Thickness of the sheets, for faces that name none of their own</source>
        <translation>板材の厚さ(面に指定がない場合)</translation>
    </message>
    <message>
        <source>Thickness of the wall</source>
        <translation>壁の厚さ</translation>
    </message>
    <message>
        <source>This line is 100 mm long. If yours is not, print again at 100 %, not fitted to the page.</source>
        <translation>この線は 100 mm です。違う場合は、ページに合わせず 100 % で印刷し直してください。</translation>
    </message>
    <message>
        <source>This needs Python packages that are not installed: {}.
They are put into FreeCAD's own folder, and may take some minutes and up to 2 GB.</source>
        <translation>必要な Python パッケージがありません: {}。
FreeCAD のフォルダーに入れます。数分と最大 2 GB かかることがあります。</translation>
    </message>
    <message>
        <source>This photo seems cropped: no camera takes photos of {0} x {1} px.</source>
        <translation>この写真は切り抜かれているようです。{0} x {1} px の写真を撮るカメラはありません。</translation>
    </message>
    <message>
        <source>This photo seems cropped: the camera wrote {0} x {1} px, {2} x {3} px are left.</source>
        <translation>この写真は切り抜かれているようです。カメラは {0} x {1} px を記録し、残りは {2} x {3} px です。</translation>
    </message>
    <message>
        <source>Tile the PDF on A4, A3 or letter pages</source>
        <translation>PDF を A4、A3、レターに分割</translation>
    </message>
    <message>
        <source>Too many copies ({} and so on): take some symmetry planes away.</source>
        <translation>コピーが多すぎます ({} など)。対称面をいくつか取り除いてください。</translation>
    </message>
    <message>
        <source>True where no length says how big the object is: its longest edge is 100 mm then</source>
        <translation>長さの指定がないとき真。最長の辺を 100 mm とします</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>再試行</translation>
    </message>
    <message>
        <source>Type a length, such as 210, 21 cm, 3/4 in or 2*18 mm + 5 mm</source>
        <translation>長さを入力してください(例: 210、21 cm、3/4 in、2*18 mm + 5 mm)</translation>
    </message>
    <message>
        <source>Unknowns: {} before, {} with what is true</source>
        <translation>未知数: 指定前 {}、指定後 {}</translation>
    </message>
    <message>
        <source>View through photo</source>
        <translation>写真を通して見る</translation>
    </message>
    <message>
        <source>What fingers, play and kerf come to, in millimetres</source>
        <translation>ほぞ、あそび、切り幅の結果(mm)</translation>
    </message>
    <message>
        <source>What in the photo tells the camera: four corners in px, and the sides in mm</source>
        <translation>写真の中でカメラを決めるもの：4 つの角（px）と辺の長さ（mm）</translation>
    </message>
    <message>
        <source>What is true</source>
        <translation>成り立つこと</translation>
    </message>
    <message>
        <source>What the last recompute has to say</source>
        <translation>最後の再計算の内容</translation>
    </message>
    <message>
        <source>What the object shares with existing things</source>
        <translation>既存の物と重なっている部分</translation>
    </message>
    <message>
        <source>What the printer can print at once, in mm; 0 for unknown</source>
        <translation>一度に印刷できる大きさ(mm)。0 は不明</translation>
    </message>
    <message>
        <source>What the printer can print; thinner walls are refused</source>
        <translation>印刷できる最小の厚さ。これより薄い壁は拒否</translation>
    </message>
    <message>
        <source>What was drawn over the photo, as the text of a sketch file</source>
        <translation>写真の上に描いた内容(スケッチファイルのテキスト)</translation>
    </message>
    <message>
        <source>Where the direction that is up lies on the sheet</source>
        <translation>上方向を板材のどちらに向けるか</translation>
    </message>
    <message>
        <source>Where the material lies: inside means that the drawn faces are the outside</source>
        <translation>材料の位置。inside なら描いた面が外側です</translation>
    </message>
    <message>
        <source>Where the wall lies: inside means that the drawn faces are the outside</source>
        <translation>壁の位置。inside なら描いた面が外側です</translation>
    </message>
    <message>
        <source>Whether each of these things fits</source>
        <translation>各物が収まるかどうか</translation>
    </message>
    <message>
        <source>Whether it stands, and when it tips over</source>
        <translation>立つかどうか、いつ倒れるか</translation>
    </message>
    <message>
        <source>Whether it stays as it is</source>
        <translation>そのまま立っているかどうか</translation>
    </message>
    <message>
        <source>Which end of a surface of revolution has no wall</source>
        <translation>回転体のどちらの端を開けるか</translation>
    </message>
    <message>
        <source>Which of them</source>
        <translation>そのうちのどれか</translation>
    </message>
    <message>
        <source>Which plate each of the solids is</source>
        <translation>それぞれの立体がどの板か</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Will it stand?</source>
        <translation>立ちますか？</translation>
    </message>
    <message>
        <source>Wood for a laser, over a photo of six books on a desk</source>
        <translation>机の上の6冊の本の写真に描いた、レーザー用の木の板</translation>
    </message>
    <message>
        <source>Write a marker to print as PDF or SVG: on the ground in a photo, it gives the camera and the scale</source>
        <translation>印刷用のマーカーを PDF か SVG で書き出します。写真の地面に写っていれば、カメラと縮尺が決まります</translation>
    </message>
    <message>
        <source>Write the plates as DXF, SVG, STEP and plates.json into a folder; where a fit test is selected, write that</source>
        <translation>板を DXF、SVG、STEP、plates.json としてフォルダーに書き出します。はめ合い試験片を選んでいればそれを書き出します</translation>
    </message>
    <message>
        <source>Write the shelled solid as STL, 3MF and STEP into a folder</source>
        <translation>中空の立体を STL、3MF、STEP としてフォルダーに書き出す</translation>
    </message>
    <message>
        <source>a closed set of faces</source>
        <translation>閉じた面の組</translation>
    </message>
    <message>
        <source>a joint names no edge</source>
        <translation>継手に辺がありません</translation>
    </message>
    <message>
        <source>a larger printer, or several parts</source>
        <translation>大きいプリンターにするか、分割する</translation>
    </message>
    <message>
        <source>a larger sheet, or a smaller margin</source>
        <translation>大きい板材、またはより小さな余白</translation>
    </message>
    <message>
        <source>a larger sheet, or another grain</source>
        <translation>大きい板材、または別の木目方向</translation>
    </message>
    <message>
        <source>a hole of {} x {} mm is narrower than the kerf of {} mm</source>
        <translation>{} x {} mm の穴が切り幅 {} mm より狭いです</translation>
    </message>
    <message>
        <source>a notch that a beam of {} mm just gets into is narrower than the kerf of {} mm</source>
        <translation>幅 {} mm の光線がやっと入る切り欠きは、切り幅 {} mm より狭いです</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>大きい板材</translation>
    </message>
    <message>
        <source>a lifted model</source>
        <translation>起こしたモデル</translation>
    </message>
    <message>
        <source>a notch or hole has no room for a cutter of {} mm: one of {} mm just gets in</source>
        <translation>切り欠きか穴に {} mm の刃が入りません: {} mm の刃ならやっと入ります</translation>
    </message>
    <message>
        <source>a number from {} to {} mm</source>
        <translation>{} から {} mm の数</translation>
    </message>
    <message>
        <source>a number from {} to {} {}</source>
        <translation>{} から {} {} の数</translation>
    </message>
    <message>
        <source>a photo sketch</source>
        <translation>写真スケッチ</translation>
    </message>
    <message>
        <source>a plate of {} x {} mm does not fit on a sheet of {} x {} mm with a margin of {} mm</source>
        <translation>{} x {} mm の板は {} x {} mm の板材 (余白 {} mm) に収まりません</translation>
    </message>
    <message>
        <source>a plate set</source>
        <translation>板のセット</translation>
    </message>
    <message>
        <source>a shelled solid</source>
        <translation>中空の立体</translation>
    </message>
    <message>
        <source>a side that runs from circle to circle</source>
        <translation>円から円へ続く側線</translation>
    </message>
    <message>
        <source>a thicker wall</source>
        <translation>壁を厚くする</translation>
    </message>
    <message>
        <source>a thicker wall, or a printer with a finer nozzle</source>
        <translation>壁を厚くするか、細いノズルのプリンターにする</translation>
    </message>
    <message>
        <source>a thickness above 0 mm</source>
        <translation>0 mm より大きい厚さ</translation>
    </message>
    <message>
        <source>a thickness of {} mm</source>
        <translation>厚さ {} mm</translation>
    </message>
    <message>
        <source>a thinner cutter, or wider fingers</source>
        <translation>細い刃にするか、ほぞを広げる</translation>
    </message>
    <message>
        <source>a thinner or thicker wall</source>
        <translation>壁を薄くするか厚くする</translation>
    </message>
    <message>
        <source>a thinner wall</source>
        <translation>壁を薄くする</translation>
    </message>
    <message>
        <source>a thinner wall, or the other side</source>
        <translation>壁を薄くするか、反対側にする</translation>
    </message>
    <message>
        <source>and</source>
        <translation>と</translation>
    </message>
    <message>
        <source>another folder, or check its permissions</source>
        <translation>別のフォルダーにするか、権限を確かめる</translation>
    </message>
    <message>
        <source>another format</source>
        <translation>別の形式</translation>
    </message>
    <message>
        <source>butt</source>
        <translation>突き付け</translation>
    </message>
    <message>
        <source>cannot write {}: {}</source>
        <translation>{} を書けません: {}</translation>
    </message>
    <message>
        <source>choose a lifted model</source>
        <translation>起こしたモデルを選択してください</translation>
    </message>
    <message>
        <source>choose a photo sketch</source>
        <translation>写真スケッチを選択してください</translation>
    </message>
    <message>
        <source>choose plates</source>
        <translation>板を選んでください</translation>
    </message>
    <message>
        <source>choose plates or a shelled solid</source>
        <translation>板またはシェル立体を選んでください</translation>
    </message>
    <message>
        <source>close a loop of edges that lies in one plane, or include a face</source>
        <translation>一つの平面にある辺の輪を閉じるか、面を含める</translation>
    </message>
    <message>
        <source>cut it first; the notch in which the tab sits well says which play to set</source>
        <translation>最初に切ってください。ほぞがちょうどよく入る切り欠きが、設定すべき遊びを示します</translation>
    </message>
    <message>
        <source>cutter</source>
        <translation>切断機</translation>
    </message>
    <message>
        <source>delete it or draw it again</source>
        <translation>削除するか描き直す</translation>
    </message>
    <message>
        <source>draw the face's edges in order</source>
        <translation>面の辺を順に描く</translation>
    </message>
    <message>
        <source>draw the face's edges in order, without crossing</source>
        <translation>面の辺を順に、交わらないように描く</translation>
    </message>
    <message>
        <source>draw the missing face; leave it out</source>
        <translation>足りない面を描く。または開ける</translation>
    </message>
    <message>
        <source>faces that meet in their edges only</source>
        <translation>辺だけで接する面</translation>
    </message>
    <message>
        <source>fingers cannot hold here: {}</source>
        <translation>ここではほぞが持ちません: {}</translation>
    </message>
    <message>
        <source>fingers of {} mm cannot hold here</source>
        <translation>{} mm のほぞはここでは持ちません</translation>
    </message>
    <message>
        <source>{} mm or wider</source>
        <translation>{} mm 以上</translation>
    </message>
    <message>
        <source>tabs cannot hold here: {}</source>
        <translation>ここではだぼが持ちません: {}</translation>
    </message>
    <message>
        <source>flat faces beside a surface of revolution cannot be printed as one</source>
        <translation>回転体と平らな面は一体で造形できません</translation>
    </message>
    <message>
        <source>follows from the drawing and the other dimensions</source>
        <translation>図と他の寸法から決まります</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>グリッド</translation>
    </message>
    <message>
        <source>include a face</source>
        <translation>面を含める</translation>
    </message>
    <message>
        <source>it does not stand</source>
        <translation>立ちません</translation>
    </message>
    <message>
        <source>it fits</source>
        <translation>収まります</translation>
    </message>
    <message>
        <source>it has no name of 1 to 60 letters</source>
        <translation>1～60 文字の名前がありません</translation>
    </message>
    <message>
        <source>it is no JSON object</source>
        <translation>JSON オブジェクトではありません</translation>
    </message>
    <message>
        <source>it stands</source>
        <translation>立ちます</translation>
    </message>
    <message>
        <source>key {} in the sketch</source>
        <translation>スケッチでキー {}</translation>
    </message>
    <message>
        <source>lay it on another side</source>
        <translation>別の面を下にする</translation>
    </message>
    <message>
        <source>leave one of the faces out</source>
        <translation>面を一つ開ける</translation>
    </message>
    <message>
        <source>leave them out, or sketch them on their own</source>
        <translation>開けるか、別に描く</translation>
    </message>
    <message>
        <source>list the faces in the sketch</source>
        <translation>スケッチに面を列挙する</translation>
    </message>
    <message>
        <source>mm (35 mm equivalent)</source>
        <translation>mm（35 mm 換算）</translation>
    </message>
    <message>
        <source>more than two outer faces meet in these edges</source>
        <translation>これらの辺に3枚以上の外側の面が集まっています</translation>
    </message>
    <message>
        <source>more than {} pairs of edges meet</source>
        <translation>{} 組を超える辺が交わっています</translation>
    </message>
    <message>
        <source>no face to make a plate of</source>
        <translation>板にする面がありません</translation>
    </message>
    <message>
        <source>no face to make anything of</source>
        <translation>作れる面がありません</translation>
    </message>
    <message>
        <source>no two plates meet there</source>
        <translation>そこでは2枚の板が出会いません</translation>
    </message>
    <message>
        <source>no wall of {} mm can be made</source>
        <translation>{} mm の壁は作れません</translation>
    </message>
    <message>
        <source>no {} joint can be made where {}</source>
        <translation>{} の継手はここでは作れません ({})</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>walls touch each other in an edge only, which makes no solid</source>
        <translation>壁どうしが一本の辺だけで接しており、立体になりません</translation>
    </message>
    <message>
        <source>leave fewer faces out</source>
        <translation>開ける面を減らす</translation>
    </message>
    <message>
        <source>the walls have {} mm3 instead of {}</source>
        <translation>壁の体積が {} mm³ です (正しくは {})</translation>
    </message>
    <message>
        <source>bodies that share a face, or lie apart</source>
        <translation>立体どうしが面を共有するか、離れるようにする</translation>
    </message>
    <message>
        <source>nothing is left of the walls</source>
        <translation>壁が残りません</translation>
    </message>
    <message>
        <source>nothing is traced on the photo to fit to</source>
        <translation>合わせる物が写真でなぞられていません</translation>
    </message>
    <message>
        <source>only shown: to say it, draw an upright edge from the ground to there</source>
        <translation>表示のみ：指定するには、地面からそこまで垂直なエッジを描いてください</translation>
    </message>
    <message>
        <source>or</source>
        <translation>または</translation>
    </message>
    <message>
        <source>other CAD programs</source>
        <translation>ほかの CAD</translation>
    </message>
    <message>
        <source>parts list</source>
        <translation>部品表</translation>
    </message>
    <message>
        <source>photo corner</source>
        <translation>写真の角</translation>
    </message>
    <message>
        <source>photo edge</source>
        <translation>写真のエッジ</translation>
    </message>
    <message>
        <source>plates or a shelled solid</source>
        <translation>板またはシェル立体</translation>
    </message>
    <message>
        <source>px down</source>
        <translation>px 下</translation>
    </message>
    <message>
        <source>px right,</source>
        <translation>px 右、</translation>
    </message>
    <message>
        <source>revolution {} is not solved</source>
        <translation>回転体 {} が解けていません</translation>
    </message>
    <message>
        <source>right-angle annotations, or split the faces</source>
        <translation>直角を指定するか、面を分ける</translation>
    </message>
    <message>
        <source>right-angle annotations, so that it becomes flat</source>
        <translation>直角を指定して平らにする</translation>
    </message>
    <message>
        <source>said to be right in the sketch</source>
        <translation>スケッチで直角と指定されています</translation>
    </message>
    <message>
        <source>scripts</source>
        <translation>スクリプト</translation>
    </message>
    <message>
        <source>select one set of plates or one shelled solid; each goes into a file of its own</source>
        <translation>板の組またはシェルを 1 つ選択してください。それぞれ別のファイルになります</translation>
    </message>
    <message>
        <source>select {} first</source>
        <translation>先に{}を選択してください</translation>
    </message>
    <message>
        <source>slicer</source>
        <translation>スライサー</translation>
    </message>
    <message>
        <source>slicer, with units</source>
        <translation>スライサー（単位付き）</translation>
    </message>
    <message>
        <source>solve the sketch again</source>
        <translation>スケッチをもう一度解く</translation>
    </message>
    <message>
        <source>stopped; recompute it to begin again</source>
        <translation>停止しました。再計算するともう一度始まります</translation>
    </message>
    <message>
        <source>the Python package {0} is missing; install it with FreeCAD's Addon Manager, or with: {1} -m pip install --target {2} {0}</source>
        <translation>Python パッケージ {0} がありません。FreeCAD のアドオンマネージャーか次のコマンドでインストールしてください: {1} -m pip install --target {2} {0}</translation>
    </message>
    <message>
        <source>the STEP file could not be written</source>
        <translation>STEP ファイルを書けませんでした</translation>
    </message>
    <message>
        <source>the face has no area</source>
        <translation>面の面積がありません</translation>
    </message>
    <message>
        <source>the face has no thickness</source>
        <translation>面に厚さがありません</translation>
    </message>
    <message>
        <source>the face is {} mm off its plane</source>
        <translation>面が平面から {} mm ずれています</translation>
    </message>
    <message>
        <source>the faces do not close: these edges lie open</source>
        <translation>面が閉じていません。これらの辺が開いています</translation>
    </message>
    <message>
        <source>the faces do not enclose anything</source>
        <translation>面が何も囲んでいません</translation>
    </message>
    <message>
        <source>the faces enclose no solid</source>
        <translation>面が立体を囲んでいません</translation>
    </message>
    <message>
        <source>the joint's {} is {} mm</source>
        <translation>継手の {} が {} mm です</translation>
    </message>
    <message>
        <source>the mesh holds {} mm3 instead of {}</source>
        <translation>メッシュの体積が {} mm³ です (正しくは {})</translation>
    </message>
    <message>
        <source>the outline crosses itself</source>
        <translation>輪郭が自分と交わっています</translation>
    </message>
    <message>
        <source>for material outside of the face or in its middle, its outline moves by {} mm and crosses itself: an edge of {} mm would run the other way</source>
        <translation>面の外側や中央に材料があると、輪郭が {} mm ずれて自分自身と交わります。長さ {} mm の稜線の向きが逆になります</translation>
    </message>
    <message>
        <source>the plates would lie in one another: their faces are {} mm apart, and they are {} and {} mm thick</source>
        <translation>板が重なります。面の間隔は {} mm、板の厚さは {} mm と {} mm です</translation>
    </message>
    <message>
        <source>the plates would lie in one another: {} takes {} of {}, with {} and {} mm</source>
        <translation>板が重なります。{} が {} だけ {} を占めます。厚さは {} mm と {} mm です</translation>
    </message>
    <message>
        <source>plates of {} mm cut {} into {} pieces {} mm apart</source>
        <translation>厚さ {} mm の板では {} が {} 個に分かれ、その間隔は {} mm です</translation>
    </message>
    <message>
        <source>plates of {} mm leave nothing of {}, {} mm wide</source>
        <translation>厚さ {} mm の板では {} は何も残りません。幅は {} mm です</translation>
    </message>
    <message>
        <source>another joint at {}, or thinner plates</source>
        <translation>{} を別の継手にするか、板を薄くする</translation>
    </message>
    <message>
        <source>thinner plates, or more room between these faces</source>
        <translation>板を薄くするか、これらの面の間隔を広げる</translation>
    </message>
    <message>
        <source>{} plates meet in one edge, and joints are of two</source>
        <translation>一つの稜線で {} 枚の板が合います。継ぎ手は二枚の間のものです</translation>
    </message>
    <message>
        <source>these faces are not flat: corners lie up to {} mm off</source>
        <translation>これらの面は平らではありません。角が最大 {} mm ずれています</translation>
    </message>
    <message>
        <source>the preset {} cannot be read: {}</source>
        <translation>プリセット {} を読めません: {}</translation>
    </message>
    <message>
        <source>the print is {} mm, larger than the printer's {} mm</source>
        <translation>造形物は {} mm で、プリンターの {} mm より大きいです</translation>
    </message>
    <message>
        <source>the profile crosses itself or the axis</source>
        <translation>断面が自分か軸と交わっています</translation>
    </message>
    <message>
        <source>the sketch is not solved: {}</source>
        <translation>スケッチが解けていません: {}</translation>
    </message>
    <message>
        <source>the surface is not closed</source>
        <translation>表面が閉じていません</translation>
    </message>
    <message>
        <source>the surface is not closed: {}</source>
        <translation>表面が閉じていません: {}</translation>
    </message>
    <message>
        <source>the wall of {} mm is thinner than the least wall of {} mm</source>
        <translation>壁 {} mm は最小の壁 {} mm より薄いです</translation>
    </message>
    <message>
        <source>the wall of {} mm is too thick for this profile</source>
        <translation>壁 {} mm はこの断面には厚すぎます</translation>
    </message>
    <message>
        <source>the wall of {} mm is too thick: the shape measures {} mm here</source>
        <translation>壁 {} mm は厚すぎます。形はここで {} mm です</translation>
    </message>
    <message>
        <source>the walls make {} solids instead of one</source>
        <translation>壁が一つでなく {} 個の立体になります</translation>
    </message>
    <message>
        <source>the {} is {} {}</source>
        <translation>{} が {} {} です</translation>
    </message>
    <message>
        <source>the {} is {}, no number</source>
        <translation>{}: {} は数ではありません</translation>
    </message>
    <message>
        <source>the {} is {}, not {} numbers</source>
        <translation>{}: {} は {} 個の数ではありません</translation>
    </message>
    <message>
        <source>a joint is no JointChoice</source>
        <translation>継手が JointChoice ではありません</translation>
    </message>
    <message>
        <source>{} numbers</source>
        <translation>{} 個の数</translation>
    </message>
    <message>
        <source>there is no joint {}</source>
        <translation>継手 {} はありません</translation>
    </message>
    <message>
        <source>there is no picture in the clipboard; copy one first</source>
        <translation>クリップボードに画像がありません。先にコピーしてください</translation>
    </message>
    <message>
        <source>there is no plate {0} any more</source>
        <translation>板 {0} はもうありません</translation>
    </message>
    <message>
        <source>there is no preset {}</source>
        <translation>プリセット {} はありません</translation>
    </message>
    <message>
        <source>these faces are a body of their own, or a hollow within the other one</source>
        <translation>これらの面は別の立体か、もう一つの立体の中の空洞です</translation>
    </message>
    <message>
        <source>thinner plates</source>
        <translation>板を薄くする</translation>
    </message>
    <message>
        <source>true size on paper</source>
        <translation>紙に実寸</translation>
    </message>
    <message>
        <source>type a value or an expression</source>
        <translation>値または式を入力</translation>
    </message>
    <message>
        <source>waits for {}</source>
        <translation>{} を待っています</translation>
    </message>
    <message>
        <source>what lies on the ground has no height, and what is mirrored follows what is drawn: select something else</source>
        <translation>地面にあるものに高さはなく、鏡像は描いたものに従います。ほかのものを選択してください</translation>
    </message>
    <message>
        <source>{0} cannot be written as {1}; there are: {2}</source>
        <translation>{0} は {1} として書き出せません。使えるのは {2} です</translation>
    </message>
    <message>
        <source>{0} cannot hold together with {1}: try removing {0}.</source>
        <translation>{0} は {1} と両立しません。{0} を外してみてください。</translation>
    </message>
    <message>
        <source>{0} cannot hold: try removing {0}.</source>
        <translation>{0} は成り立ちません。{0} を外してみてください。</translation>
    </message>
    <message>
        <source>{0} is no preset: {1}</source>
        <translation>{0} はプリセットではありません: {1}</translation>
    </message>
    <message>
        <source>{0} plates on {1} sheets ({2}), {3:.2f} m of cuts, about {4} min</source>
        <translation>板 {0} 枚、シート {1} 枚（{2}）、切断 {3:.2f} m、約 {4} 分</translation>
    </message>
    <message>
        <source>{0} traced lines, the worst ({1}) {2:.1f} px off.</source>
        <translation>なぞった線 {0} 本、最大のずれは {1} の {2:.1f} px です。</translation>
    </message>
    <message>
        <source>{0}: an edge or face of {1} that it was built on is gone: choose another</source>
        <translation>{0}: 基にしていた {1} の辺または面がなくなりました。別のものを選んでください</translation>
    </message>
    <message>
        <source>{0}: edge {1}, from {2} to {3}</source>
        <translation>{0}: 辺 {1}({2} から {3})</translation>
    </message>
    <message>
        <source>{:.1f} cm3 of material</source>
        <translation>材料 {:.1f} cm3</translation>
    </message>
    <message>
        <source>{} cannot all hold: take one of them away.</source>
        <translation>{} はすべて同時には成り立ちません。どれか一つを外してください。</translation>
    </message>
    <message>
        <source>{} conditions on {} coordinates are left</source>
        <translation>{} 個の条件と {} 個の座標</translation>
    </message>
    <message>
        <source>{} contradicts the rest: with it the drawing is missed by {} px, without it by {} px.</source>
        <translation>{} は残りと矛盾します。あると図から {} px、ないと {} px 外れます。</translation>
    </message>
    <message>
        <source>{} coordinates are free</source>
        <translation>自由な座標 {} 個</translation>
    </message>
    <message>
        <source>{} does not meet this edge</source>
        <translation>{} はこの辺に接していません</translation>
    </message>
    <message>
        <source>{} drawn without width or height: pull the ellipse open.</source>
        <translation>{} に幅か高さがありません。楕円を広げてください。</translation>
    </message>
    <message>
        <source>{} ends on {}, which must own the ends</source>
        <translation>{} は {} の上で終わるので、端は後者のものです</translation>
    </message>
    <message>
        <source>{} freedom left: add a right angle, parallel or ground vertex at {}.</source>
        <translation>自由度が {} 残っています。{} に直角、平行、地面の指定を加えてください。</translation>
    </message>
    <message>
        <source>{} freedom left: give the diameter of {}, or join circles of one axis to a surface of revolution (V).</source>
        <translation>自由度が {} 残っています。{} の直径を指定するか、同じ軸の円を回転体にまとめてください (V)。</translation>
    </message>
    <message>
        <source>{} freedom left: nothing is said to be square or parallel; begin with right angles at {}.</source>
        <translation>自由度が {} 残っています。直角も平行も指定されていません。まず {} に直角を付けてください。</translation>
    </message>
    <message>
        <source>{} freedoms left: add a right angle, parallel or ground vertex at {}.</source>
        <translation>自由度が {} 残っています。{} に直角、平行、地面の指定を加えてください。</translation>
    </message>
    <message>
        <source>{} freedoms left: give the diameter of {}, or join circles of one axis to a surface of revolution (V).</source>
        <translation>自由度が {} 残っています。{} の直径を指定するか、同じ軸の円を回転体にまとめてください (V)。</translation>
    </message>
    <message>
        <source>{} freedoms left: nothing is said to be square or parallel; begin with right angles at {}.</source>
        <translation>自由度が {} 残っています。直角も平行も指定されていません。まず {} に直角を付けてください。</translation>
    </message>
    <message>
        <source>{} had been opened or saved without this addon and had lost what makes them follow the sketch; they have it again</source>
        <translation>{} はこのアドオンなしで開くか保存され、スケッチに追従しなくなっていました。元に戻しました</translation>
    </message>
    <message>
        <source>{} is no joint</source>
        <translation>{} は継手ではありません</translation>
    </message>
    <message>
        <source>{} is not there; use the command below.</source>
        <translation>{} がありません。下のコマンドを使ってください。</translation>
    </message>
    <message>
        <source>{} of {} things are in the way</source>
        <translation>{} / {} 個の物とぶつかります</translation>
    </message>
    <message>
        <source>{} or a .json file</source>
        <translation>{} または .json ファイル</translation>
    </message>
    <message>
        <source>{} plates</source>
        <translation>板 {} 枚</translation>
    </message>
    <message>
        <source>{} vertices, {} edges, {} annotations</source>
        <translation>頂点 {}、辺 {}、注釈 {}</translation>
    </message>
    <message>
        <source>{} was saved by a newer version of this addon; what it added is left as it is</source>
        <translation>{} は新しい版のアドオンで保存されました。追加された内容はそのまま残ります</translation>
    </message>
    <message>
        <source>{}, too many to solve for: mark right angles and parallels.</source>
        <translation>{} は多すぎて解けません。直角と平行を指定してください。</translation>
    </message>
    <message>
        <source>{}; try: {}</source>
        <translation>{}。対処: {}</translation>
    </message>
    <message>
        <source>Lifting the sketch to 3D ...</source>
        <translation>スケッチを 3D に起こしています…</translation>
    </message>
    <message>
        <source>Making the plates ...</source>
        <translation>板を作成しています…</translation>
    </message>
    <message>
        <source>Looking how the plates go together ...</source>
        <translation>板の組み立て順を調べています…</translation>
    </message>
    <message>
        <source>Making the solid; the first time takes some seconds ...</source>
        <translation>立体を作成しています。最初は数秒かかります…</translation>
    </message>
    <message>
        <source>Laying the plates out on sheets ...</source>
        <translation>板を板材に配置しています…</translation>
    </message>
    <message>
        <source>Writing the {} file ...</source>
        <translation>{} ファイルを書き出しています…</translation>
    </message>
    <message>
        <source>Checking the fit ...</source>
        <translation>適合を確認しています…</translation>
    </message>
    <message>
        <source>Looking at the straight lines in the photo ...</source>
        <translation>写真の中のまっすぐな線を調べています…</translation>
    </message>
    <message>
        <source>Straightening the photo ...</source>
        <translation>写真の歪みを補正しています…</translation>
    </message>
    <message>
        <source>Looking for the corners in the photo ...</source>
        <translation>写真の中の角を探しています…</translation>
    </message>
    <message>
        <source>{}: {} between {} and {} at {} degrees ({})</source>
        <translation>{}: {}、{} と {} の間、{} 度（{}）</translation>
    </message>
    <message>
        <source>{}: {} between {} and {} at {} degrees</source>
        <translation>{}: {}、{} と {} の間、{} 度</translation>
    </message>
    <message>
        <source>{} between {} and {} at {} degrees ({})</source>
        <translation>{}、{} と {} の間、{} 度（{}）</translation>
    </message>
    <message>
        <source>{} between {} and {} at {} degrees</source>
        <translation>{}、{} と {} の間、{} 度</translation>
    </message>
    <message>
        <source>finger</source>
        <translation>ほぞ</translation>
    </message>
    <message>
        <source>half lap</source>
        <translation>相欠き</translation>
    </message>
    <message>
        <source>tab slot</source>
        <translation>差し込み</translation>
    </message>
    <message>
        <source>none</source>
        <translation>継手なし</translation>
    </message>
    <message>
        <source>{} degrees; fingers hold from 30 to 150 degrees</source>
        <translation>{} 度。ほぞが持つのは 30 〜 150 度です</translation>
    </message>
    <message>
        <source>{} mm clear of the corners; fingers need {} mm at least</source>
        <translation>角の間が {} mm。ほぞには少なくとも {} mm が必要です</translation>
    </message>
    <message>
        <source>{} and {} more: fingers of {} mm would not hold, they are {} mm wide or wider</source>
        <translation>{} ほか {} か所: {} mm のほぞでは持たないので、{} mm 以上にします</translation>
    </message>
    <message>
        <source>{}: fingers of {} mm would not hold, they are {} mm wide or wider</source>
        <translation>{}: {} mm のほぞでは持たないので、{} mm 以上にします</translation>
    </message>
    <message>
        <source>fingers would cut {} into pieces</source>
        <translation>ほぞが {} を切り離してしまいます</translation>
    </message>
    <message>
        <source>slots would be less than {} mm from a border of {}</source>
        <translation>溝が縁から {} mm 未満になります ({})</translation>
    </message>
    <message>
        <source>{}: the slot for {} ({}) is {} mm from a border, less than the plate's {} mm; it may break</source>
        <translation>{}: {} ({}) のスロットは縁から {} mm で、板厚 {} mm より近くにあります。割れるかもしれません</translation>
    </message>
    <message>
        <source>{}: the slot for {} is {} mm from a border, less than the plate's {} mm; it may break</source>
        <translation>{}: {} のスロットは縁から {} mm で、板厚 {} mm より近くにあります。割れるかもしれません</translation>
    </message>
    <message>
        <source>{} meet in a point: {} mm3 stay empty there, which square cuts cannot fill</source>
        <translation>{} は一点で接しています: そこに {} mm³ の空きが残り、垂直な切断では埋められません</translation>
    </message>
    <message>
        <source>begin with {}</source>
        <translation>{} から始める</translation>
    </message>
    <message>
        <source>put {} on, moving along ({}, {}, {})</source>
        <translation>{} を ({}, {}, {}) の向きに取り付ける</translation>
    </message>
    <message>
        <source>cannot be put together: {} lock each other</source>
        <translation>組み立てられません。{} が互いに妨げます</translation>
    </message>
    <message>
        <source>a butt joint between them</source>
        <translation>その間を突き付けにする</translation>
    </message>
    <message>
        <source>finger at a corner: {} mm wide, its cut path {} mm</source>
        <translation>角のほぞ: 幅 {} mm、切断線 {} mm</translation>
    </message>
    <message>
        <source>notch at a corner: {} mm wide, its cut path {} mm</source>
        <translation>角の切り欠き: 幅 {} mm、切断線 {} mm</translation>
    </message>
    <message>
        <source>tab: {} mm wide, its cut path {} mm</source>
        <translation>差し込むほぞ: 幅 {} mm、切断線 {} mm</translation>
    </message>
    <message>
        <source>slot: {} x {} mm, its cut path {} x {} mm</source>
        <translation>溝: {} x {} mm、切断線 {} x {} mm</translation>
    </message>
    <message>
        <source>kerf {} mm: paths lie {} mm outside of outlines and inside of holes</source>
        <translation>切り幅 {} mm: 切断線は外形の外側、穴の内側に {} mm ずれます</translation>
    </message>
    <message>
        <source>kerf 0 mm: paths are the finished sizes; whoever cuts has to allow for the beam</source>
        <translation>切り幅 0 mm: 切断線は仕上がり寸法です。切る人が刃の幅を見込みます</translation>
    </message>
    <message>
        <source>play {} mm: between a finger and its notch, a tab and its slot, there are {} mm on each side</source>
        <translation>あそび {} mm: ほぞと切り欠き、差し込みと溝の間は両側 {} mm ずつです</translation>
    </message>
    <message>
        <source>{} for a cutter of {} mm: cuts {} mm beyond the sides of inner corners</source>
        <translation>{}（刃 {} mm）: 内側の角を {} mm 越えて切ります</translation>
    </message>
    <message>
        <source>dog bone</source>
        <translation>ドッグボーン</translation>
    </message>
    <message>
        <source>T-bone</source>
        <translation>T ボーン</translation>
    </message>
    <message>
        <source>it stands: its centre of mass lies {0} mm within what it stands on; it tips {1} when the ground leans by {2} degrees</source>
        <translation>立ちます。重心は接地面の内側 {0} mm。地面が {2} 度傾くと{1}倒れます</translation>
    </message>
    <message>
        <source>it stands (easily knocked over): its centre of mass lies {0} mm within what it stands on; it tips {1} when the ground leans by {2} degrees</source>
        <translation>立ちます（倒れやすい）。重心は接地面の内側 {0} mm。地面が {2} 度傾くと{1}倒れます</translation>
    </message>
    <message>
        <source>it does not stand: it touches the ground in a line only, and tips {}</source>
        <translation>立ちません。地面に線でしか接せず、{}倒れます</translation>
    </message>
    <message>
        <source>it does not stand: it tips {}, its centre of mass lies {} mm beyond what it stands on</source>
        <translation>立ちません。{}倒れます。重心は接地面の外側 {} mm です</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>左へ</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>右へ</translation>
    </message>
    <message>
        <source>to the front</source>
        <translation>手前へ</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>奥へ</translation>
    </message>
    <message>
        <source>nothing to fit to: trace what is there, and make it construction</source>
        <translation>合わせる物がありません。そこにある物をなぞり、補助線にしてください</translation>
    </message>
    <message>
        <source>{} (which will stand {} mm higher)</source>
        <translation>{}（{} mm 高くなります）</translation>
    </message>
    <message>
        <source>{}: lies on the ground, nothing runs into it</source>
        <translation>{}: 地面にあり、何もぶつかりません</translation>
    </message>
    <message>
        <source>{}: does not fit, it reaches {}; one pixel of the photo is {} mm there</source>
        <translation>{}: 収まりません。{}。写真の 1 px はそこで {} mm です</translation>
    </message>
    <message>
        <source>{}: does not fit, it reaches {}</source>
        <translation>{}: 収まりません。{}</translation>
    </message>
    <message>
        <source>{}: fits, {}; room: {}; one pixel of the photo is {} mm there</source>
        <translation>{}: 収まります。{}。余裕: {}。写真の 1 px はそこで {} mm です</translation>
    </message>
    <message>
        <source>{}: fits, {}; one pixel of the photo is {} mm there</source>
        <translation>{}: 収まります。{}。写真の 1 px はそこで {} mm です</translation>
    </message>
    <message>
        <source>{}: fits, {}; room: {}</source>
        <translation>{}: 収まります。{}。余裕: {}</translation>
    </message>
    <message>
        <source>{}: fits, {}</source>
        <translation>{}: 収まります。{}</translation>
    </message>
    <message>
        <source>nothing near</source>
        <translation>近くに何もありません</translation>
    </message>
    <message>
        <source>touches {}</source>
        <translation>{} に接しています</translation>
    </message>
    <message>
        <source>{0} mm from {1}</source>
        <translation>{1} から {0} mm</translation>
    </message>
    <message>
        <source>{0} mm into {1}</source>
        <translation>{1} に {0} mm 食い込みます</translation>
    </message>
    <message>
        <source>free {}</source>
        <translation>{}は空き</translation>
    </message>
    <message>
        <source>{} mm left</source>
        <translation>左 {} mm</translation>
    </message>
    <message>
        <source>{} mm right</source>
        <translation>右 {} mm</translation>
    </message>
    <message>
        <source>{} mm front</source>
        <translation>手前 {} mm</translation>
    </message>
    <message>
        <source>{} mm back</source>
        <translation>奥 {} mm</translation>
    </message>
    <message>
        <source>{} mm up</source>
        <translation>上 {} mm</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>front</source>
        <translation>手前</translation>
    </message>
    <message>
        <source>back</source>
        <translation>奥</translation>
    </message>
    <message>
        <source>up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>mark {}</source>
        <translation>印 {}</translation>
    </message>
    <message>
        <source>block {}</source>
        <translation>箱 {}</translation>
    </message>
    <message>
        <source>surface {}</source>
        <translation>面 {}</translation>
    </message>
    <message>
        <source>cylinder {}</source>
        <translation>円柱 {}</translation>
    </message>
    <message>
        <source>{} is held by glue alone ({})</source>
        <translation>{} は接着だけで留まります（{}）</translation>
    </message>
    <message>
        <source>{} is held by one joint only ({}); glue it</source>
        <translation>{} は一か所の継手だけで留まります（{}）。接着してください</translation>
    </message>
    <message>
        <source>nothing joins these to one another: {}</source>
        <translation>これらをつなぐものがありません: {}</translation>
    </message>
    <message>
        <source>{0} is thinner than {1} mm about ({2}, {3}) mm from its corner: it breaks there</source>
        <translation>{0} は角から ({2}, {3}) mm のあたりで {1} mm より細く、そこで折れます</translation>
    </message>
    <message>
        <source>walls are thinner than the printer's line of {0} mm from {1} to {2} mm above the lowest point: they are not printed there</source>
        <translation>最も低い点から {1} 〜 {2} mm の壁がプリンターの線幅 {0} mm より薄く、印刷されません</translation>
    </message>
    <message>
        <source>the photo {} lies outside the sketch's folder and is not opened</source>
        <translation>写真 {} はスケッチのフォルダーの外にあるため開きません</translation>
    </message>
    <message>
        <source>the photo {} is not there; it is left out</source>
        <translation>写真 {} がありません。なしで続けます</translation>
    </message>
    <message>
        <source>the photo {} cannot be opened: {}</source>
        <translation>写真 {} を開けません: {}</translation>
    </message>
    <message>
        <source>the photo {} cannot be read: {}</source>
        <translation>写真 {} を読めません: {}</translation>
    </message>
    <message>
        <source>the photo {} has {} megapixels, more than {}</source>
        <translation>写真 {} は {} メガピクセルで、{} を超えています</translation>
    </message>
    <message>
        <source>a smaller copy of it</source>
        <translation>縮小したコピーを使う</translation>
    </message>
    <message>
        <source>cannot read the photo {}: {}</source>
        <translation>写真 {} を読めません: {}</translation>
    </message>
    <message>
        <source>save it as JPEG or PNG (read here are {})</source>
        <translation>JPEG か PNG で保存する（ここで読めるのは {}）</translation>
    </message>
    <message>
        <source>it is no picture</source>
        <translation>画像ではありません</translation>
    </message>
    <message>
        <source>the photo is {} x {} px, the sketch says {} x {}</source>
        <translation>写真は {} x {} px ですが、スケッチでは {} x {} です</translation>
    </message>
    <message>
        <source>{} is {}, not an object</source>
        <translation>{} は {} で、オブジェクトではありません</translation>
    </message>
    <message>
        <source>{} is {}, not a list</source>
        <translation>{} は {} で、リストではありません</translation>
    </message>
    <message>
        <source>{} is {}, not a number</source>
        <translation>{} は {} で、数ではありません</translation>
    </message>
    <message>
        <source>{} is {}, not an id</source>
        <translation>{} は {} で、ID ではありません</translation>
    </message>
    <message>
        <source>{} is {}, too large</source>
        <translation>{} は {} で、大きすぎます</translation>
    </message>
    <message>
        <source>{} is not a rotation</source>
        <translation>{} は回転ではありません</translation>
    </message>
    <message>
        <source>{} is not a name</source>
        <translation>{} は名前ではありません</translation>
    </message>
    <message>
        <source>{} is not finite</source>
        <translation>{} は有限の数ではありません</translation>
    </message>
    <message>
        <source>{} is not an id</source>
        <translation>{} は ID ではありません</translation>
    </message>
    <message>
        <source>{} is not a list of ids</source>
        <translation>{} は ID のリストではありません</translation>
    </message>
    <message>
        <source>{} is not a line of text</source>
        <translation>{} は一行の文字ではありません</translation>
    </message>
    <message>
        <source>{}: an id has 1 to {} characters</source>
        <translation>{}: ID は 1 〜 {} 文字です</translation>
    </message>
    <message>
        <source>{}: an id has no spaces, control characters or '@'</source>
        <translation>{}: ID に空白、制御文字、'@' は使えません</translation>
    </message>
    <message>
        <source>{} has {} entries</source>
        <translation>{} の要素は {} 個です</translation>
    </message>
    <message>
        <source>{} lacks {}</source>
        <translation>{} に {} がありません</translation>
    </message>
    <message>
        <source>{} has an unknown key {}</source>
        <translation>{} に知らないキー {} があります</translation>
    </message>
    <message>
        <source>version {} is newer than this program, which knows {}</source>
        <translation>バージョン {} はこのプログラム（{} まで）より新しいものです</translation>
    </message>
    <message>
        <source>update Modeling in Context</source>
        <translation>Modeling in Context を更新する</translation>
    </message>
    <message>
        <source>a short id</source>
        <translation>短い ID</translation>
    </message>
    <message>
        <source>a short text</source>
        <translation>短い文字</translation>
    </message>
    <message>
        <source>a short text, {}</source>
        <translation>短い文字、{}</translation>
    </message>
    <message>
        <source>letters, digits</source>
        <translation>文字と数字</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>true/false</source>
        <translation>true/false</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限の数</translation>
    </message>
    <message>
        <source>a number up to {}</source>
        <translation>{} までの数</translation>
    </message>
    <message>
        <source>a number above {}</source>
        <translation>{} より大きい数</translation>
    </message>
    <message>
        <source>a whole number of pixels</source>
        <translation>整数のピクセル数</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true か false</translation>
    </message>
    <message>
        <source>at least {} entries</source>
        <translation>少なくとも {} 個</translation>
    </message>
    <message>
        <source>{} entries</source>
        <translation>{} 個</translation>
    </message>
    <message>
        <source>add it</source>
        <translation>追加する</translation>
    </message>
    <message>
        <source>add it, or name another</source>
        <translation>追加するか、別のものにする</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>次のどれか: {}</translation>
    </message>
    <message>
        <source>a file of format {}</source>
        <translation>形式 {} のファイル</translation>
    </message>
    <message>
        <source>a version from 1 to {}</source>
        <translation>1 〜 {} のバージョン</translation>
    </message>
    <message>
        <source>three perpendicular rows of length 1</source>
        <translation>長さ 1 で互いに垂直な 3 行</translation>
    </message>
    <message>
        <source>the photo's file name, or null</source>
        <translation>写真のファイル名か null</translation>
    </message>
    <message>
        <source>an edge and a circle share an id</source>
        <translation>辺と円の ID が同じです</translation>
    </message>
    <message>
        <source>rename one of them</source>
        <translation>片方の名前を変える</translation>
    </message>
    <message>
        <source>more than {0} {1}</source>
        <translation>{1} が {0} を超えています</translation>
    </message>
    <message>
        <source>a smaller sketch</source>
        <translation>小さいスケッチ</translation>
    </message>
    <message>
        <source>{} names a {} that is not there</source>
        <translation>{} が指す {} がありません</translation>
    </message>
    <message>
        <source>annotation {} names a face with mirrored corners</source>
        <translation>注釈 {} が鏡像の角をもつ面を指しています</translation>
    </message>
    <message>
        <source>draw its corners</source>
        <translation>その角を描く</translation>
    </message>
    <message>
        <source>an edge begins and ends at one vertex</source>
        <translation>辺の両端が同じ頂点です</translation>
    </message>
    <message>
        <source>delete it</source>
        <translation>削除する</translation>
    </message>
    <message>
        <source>two edges join the same vertices</source>
        <translation>二つの辺が同じ頂点を結んでいます</translation>
    </message>
    <message>
        <source>delete one</source>
        <translation>片方を削除する</translation>
    </message>
    <message>
        <source>face {} passes a vertex twice</source>
        <translation>面 {} が同じ頂点を二度通ります</translation>
    </message>
    <message>
        <source>split the face</source>
        <translation>面を分ける</translation>
    </message>
    <message>
        <source>annotation {} names one {} twice</source>
        <translation>注釈 {} が同じ {} を二度指しています</translation>
    </message>
    <message>
        <source>name it once</source>
        <translation>一度だけにする</translation>
    </message>
    <message>
        <source>annotation {}: edge {} does not end at {}</source>
        <translation>注釈 {}: 辺 {} の端は {} ではありません</translation>
    </message>
    <message>
        <source>two edges that meet at the vertex</source>
        <translation>その頂点で出会う二つの辺</translation>
    </message>
    <message>
        <source>{} has too few vertices, or one twice</source>
        <translation>{} の頂点が足りないか、重複しています</translation>
    </message>
    <message>
        <source>solve again</source>
        <translation>もう一度解く</translation>
    </message>
    <message>
        <source>{} is a folder, not a file</source>
        <translation>{} はファイルではなくフォルダーです</translation>
    </message>
    <message>
        <source>a file in it, {}</source>
        <translation>その中のファイル {}</translation>
    </message>
    <message>
        <source>{} is larger than {} MB</source>
        <translation>{} は {} MB を超えています</translation>
    </message>
    <message>
        <source>a sketch file</source>
        <translation>スケッチファイル</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>ファイルが空です</translation>
    </message>
    <message>
        <source>save the sketch again</source>
        <translation>スケッチを保存し直す</translation>
    </message>
    <message>
        <source>a key stands twice in one object</source>
        <translation>一つのオブジェクトに同じキーが二つあります</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>一つだけ残す</translation>
    </message>
    <message>
        <source>cannot read {}: {}</source>
        <translation>{} を読めません: {}</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>名前を確かめる</translation>
    </message>
    <message>
        <source>{} is not UTF-8 text (byte {})</source>
        <translation>{} は UTF-8 の文字ではありません（{} バイト目）</translation>
    </message>
    <message>
        <source>a sketch file, saved as UTF-8</source>
        <translation>UTF-8 で保存したスケッチファイル</translation>
    </message>
    <message>
        <source>not JSON: {} at line {}, column {}</source>
        <translation>JSON ではありません: {}（{} 行 {} 桁）</translation>
    </message>
    <message>
        <source>not JSON: {}</source>
        <translation>JSON ではありません: {}</translation>
    </message>
    <message>
        <source>the whole file: this one is cut off</source>
        <translation>途中で切れていないファイル</translation>
    </message>
    <message>
        <source>correct the text there</source>
        <translation>そこの文字を直す</translation>
    </message>
    <message>
        <source>ordinary numbers</source>
        <translation>普通の数</translation>
    </message>
    <message>
        <source>nested too deeply to be a sketch</source>
        <translation>入れ子が深すぎてスケッチではありません</translation>
    </message>
    <message>
        <source>there is no such element in the sketch</source>
        <translation>スケッチにその要素がありません</translation>
    </message>
    <message>
        <source>edges that do not meet make no angle</source>
        <translation>出会わない辺は角になりません</translation>
    </message>
    <message>
        <source>two that meet</source>
        <translation>出会う二つの辺</translation>
    </message>
    <message>
        <source>an angle of {0} degrees between {1} and {2}</source>
        <translation>{1} と {2} の間の {0} 度の角</translation>
    </message>
    <message>
        <source>nothing on the ground is known to be right below {}</source>
        <translation>{} の真下にあるとわかる地面のものがありません</translation>
    </message>
    <message>
        <source>draw an upright edge from the ground to there</source>
        <translation>地面からそこまで垂直な辺を描く</translation>
    </message>
    <message>
        <source>a {} of {} mm</source>
        <translation>{} が {} mm</translation>
    </message>
    <message>
        <source>a {} above 0</source>
        <translation>0 より大きい{}</translation>
    </message>
    <message>
        <source>length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>one above 0</source>
        <translation>0 より大きい値</translation>
    </message>
    <message>
        <source>a side of fewer than two points</source>
        <translation>側面の点が 2 個未満です</translation>
    </message>
    <message>
        <source>draw it from bottom to top</source>
        <translation>下から上へ描く</translation>
    </message>
    <message>
        <source>these corners are {0} px off any rectangle of {1} x {2} mm</source>
        <translation>これらの角は {1} x {2} mm の長方形から {0} px ずれています</translation>
    </message>
    <message>
        <source>check the size, and click the four corners again</source>
        <translation>大きさを確かめ、4 つの角をクリックし直す</translation>
    </message>
    <message>
        <source>a rectangle of {} x {} mm is none</source>
        <translation>{} x {} mm は長方形になりません</translation>
    </message>
    <message>
        <source>sides above 0 mm</source>
        <translation>0 mm より長い辺</translation>
    </message>
    <message>
        <source>a rectangle has four corners</source>
        <translation>長方形の角は 4 つです</translation>
    </message>
    <message>
        <source>click each of them once</source>
        <translation>それぞれ一度クリックする</translation>
    </message>
    <message>
        <source>two corners are almost in one place</source>
        <translation>二つの角がほぼ同じ場所にあります</translation>
    </message>
    <message>
        <source>click four different corners, zoomed in</source>
        <translation>拡大して 4 つの異なる角をクリックする</translation>
    </message>
    <message>
        <source>these corners are no rectangle seen in perspective</source>
        <translation>これらの角は遠近で見た長方形ではありません</translation>
    </message>
    <message>
        <source>click the four outer corners of one flat rectangle, seen less from the side</source>
        <translation>横から見すぎない平らな長方形の、外側の 4 つの角をクリックする</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>頂点</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>辺</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>円</translation>
    </message>
    <message>
        <source>face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>edge or circle</source>
        <translation>辺か円</translation>
    </message>
    <message>
        <source>annotation {}</source>
        <translation>注釈 {}</translation>
    </message>
    <message>
        <source>edge {}</source>
        <translation>辺 {}</translation>
    </message>
    <message>
        <source>face {}</source>
        <translation>面 {}</translation>
    </message>
    <message>
        <source>revolution {}</source>
        <translation>回転体 {}</translation>
    </message>
    <message>
        <source>construction</source>
        <translation>補助線</translation>
    </message>
    <message>
        <source>{} cannot be {}</source>
        <translation>{} を {} にはできません</translation>
    </message>
    <message>
        <source>owner {} or {}</source>
        <translation>owner {} か {}</translation>
    </message>
    <message>
        <source>owner {}</source>
        <translation>owner {}</translation>
    </message>
    <message>
        <source>side inside, or thinner plates</source>
        <translation>side を inside にするか、板を薄くする</translation>
    </message>
    <message>
        <source>a smaller kerf, or wider fingers</source>
        <translation>切り幅を小さくするか、ほぞを広げる</translation>
    </message>
    <message>
        <source>the preset {} has no layers</source>
        <translation>プリセット {} にレイヤーがありません</translation>
    </message>
    <message>
        <source>the preset {} names unknown layers</source>
        <translation>プリセット {} に知らないレイヤーがあります</translation>
    </message>
    <message>
        <source>the preset {} asks for a DXF that we do not write</source>
        <translation>プリセット {} の DXF は書き出せません</translation>
    </message>
    <message>
        <source>dxf "R2000" or "R12", lines true or false</source>
        <translation>dxf は "R2000" か "R12"、lines は true か false</translation>
    </message>
    <message>
        <source>the preset {} says something unknown of a layer</source>
        <translation>プリセット {} のレイヤーに知らない指定があります</translation>
    </message>
    <message>
        <source>the preset {} has a wrong name or colour</source>
        <translation>プリセット {} の名前か色が正しくありません</translation>
    </message>
    <message>
        <source>a name, aci from 1 to 255, rgb like #ff0000</source>
        <translation>名前、1 〜 255 の aci、#ff0000 のような rgb</translation>
    </message>
    <message>
        <source>these faces do not stand at right angles to the others</source>
        <translation>これらの面はほかの面と直角ではありません</translation>
    </message>
    <message>
        <source>right-angle annotations</source>
        <translation>直角の注釈</translation>
    </message>
    <message>
        <source>a surface of revolution has no flat face to make a plate of</source>
        <translation>回転体には板にする平らな面がありません</translation>
    </message>
    <message>
        <source>a print: a shelled solid, --print</source>
        <translation>3D プリント: シェル立体、--print</translation>
    </message>
    <message>
        <source>there is no {} {}</source>
        <translation>{} {} はありません</translation>
    </message>
    <message>
        <source>Finding the camera ...</source>
        <translation>カメラを求めています…</translation>
    </message>
    <message>
        <source>Method: {}</source>
        <translation>方法: {}</translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>方法を変更</translation>
    </message>
    <message>
        <source>nothing is drawn yet</source>
        <translation>まだ何も描かれていません</translation>
    </message>
    <message>
        <source>where these {0} faces meet in {1}, material cannot lie outside of them or in their middle: their planes, moved, meet in no point</source>
        <translation>{0} 枚の面が {1} で出会う所では、外側や中央に材料を置けません。ずらした面が一点で出会いません</translation>
    </message>
    <message>
        <source>side inside, or one thickness for all of them</source>
        <translation>side を inside にするか、厚さをそろえる</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>すべて選択</translation>
    </message>
    <message>
        <source>Whole photo</source>
        <translation>写真全体を表示</translation>
    </message>
    <message>
        <source>Click the next end, or type how long the last line is; right click stops</source>
        <translation>次の終点をクリック、または直前の線の長さを入力。右クリックで終了</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>E&amp;xamples</source>
        <translation>例(&amp;X)</translation>
    </message>
    <message>
        <source>Modeling in &amp;Context</source>
        <translation>Modeling in &amp;Context</translation>
    </message>
    <message>
        <source>Modeling in Context</source>
        <translation>Modeling in Context</translation>
    </message>
    <message>
        <source>Sketch &amp;tools</source>
        <translation>スケッチツール(&amp;T)</translation>
    </message>
    <message>
        <source>Sketch tools</source>
        <translation>スケッチツール</translation>
    </message>
</context>
</TS>
