<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP">
<context>
    <name>Actions</name>
    <message>
        <source>Not now: %1</source>
        <translation>今は使えません: %1</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新規(&amp;N)</translation>
    </message>
    <message>
        <source>Start an empty drawing.</source>
        <translation>空の図面を始めます。</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>新しいウィンドウ(&amp;W)</translation>
    </message>
    <message>
        <source>Open another window, with a drawing of its own.</source>
        <translation>別の図面のための新しいウィンドウを開きます。</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save the drawing.</source>
        <translation>図面を保存します。</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>名前を付けて保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the drawing under another name.</source>
        <translation>図面を別の名前で保存します。</translation>
    </message>
    <message>
        <source>Keep the drawing, to begin others with it.</source>
        <translation>別の図面の出発点として、この図面を残します。</translation>
    </message>
    <message>
        <source>Export Co&amp;rrected Map…</source>
        <translation>補正した地図を書き出す(&amp;R)…</translation>
    </message>
    <message>
        <source>Save the map that the run has corrected.</source>
        <translation>実行が補正した地図を保存します。</translation>
    </message>
    <message>
        <source>Export &amp;Picture…</source>
        <translation>画像を書き出す(&amp;P)…</translation>
    </message>
    <message>
        <source>Export &amp;Trajectory…</source>
        <translation>軌跡を書き出す(&amp;T)…</translation>
    </message>
    <message>
        <source>Save the way of the robot in TUM form.</source>
        <translation>ロボットの軌跡を TUM 形式で保存します。</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Leave the program.</source>
        <translation>プログラムを終了します。</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>Take back the last change.</source>
        <translation>最後の変更を取り消します。</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>Do again what was taken back.</source>
        <translation>取り消した変更をやり直します。</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>Remove what is selected.</source>
        <translation>選択したものを削除します。</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>すべて選択(&amp;A)</translation>
    </message>
    <message>
        <source>Select everything drawn.</source>
        <translation>描いたものをすべて選択します。</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>設定(&amp;S)…</translation>
    </message>
    <message>
        <source>How a run localizes and corrects.</source>
        <translation>実行が位置を推定し補正する方法。</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>拡大(&amp;I)</translation>
    </message>
    <message>
        <source>Show it larger.</source>
        <translation>大きく表示します。</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>縮小(&amp;O)</translation>
    </message>
    <message>
        <source>Show more of the map.</source>
        <translation>地図を広く表示します。</translation>
    </message>
    <message>
        <source>Zoom to &amp;Fit</source>
        <translation>全体を表示(&amp;F)</translation>
    </message>
    <message>
        <source>Show the whole map.</source>
        <translation>地図全体を表示します。</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>格子(&amp;G)</translation>
    </message>
    <message>
        <source>Show the metric grid.</source>
        <translation>メートル格子を表示します。</translation>
    </message>
    <message>
        <source>&amp;Snap to Half Metres</source>
        <translation>半メートルにスナップ(&amp;S)</translation>
    </message>
    <message>
        <source>Keep points on a grid of half a metre while drawing.</source>
        <translation>描くときに点を半メートルの格子に合わせます。</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>不確かさ(&amp;U)</translation>
    </message>
    <message>
        <source>Show by soft edges how wrong the drawing may be.</source>
        <translation>図面がどれだけ違っている可能性があるかを、ぼかした縁で示します。</translation>
    </message>
    <message>
        <source>As the &amp;System Has It</source>
        <translation>システムに合わせる(&amp;S)</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is.</source>
        <translation>デスクトップに合わせて明暗を切り替えます。</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>Dark ink on a light ground.</source>
        <translation>明るい地に暗い線。</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>ダーク(&amp;D)</translation>
    </message>
    <message>
        <source>Light ink on a dark ground.</source>
        <translation>暗い地に明るい線。</translation>
    </message>
    <message>
        <source>Language of the S&amp;ystem</source>
        <translation>システムの言語(&amp;Y)</translation>
    </message>
    <message>
        <source>Speak as the desktop does, from the next start on.</source>
        <translation>次の起動から、デスクトップの言語を使います。</translation>
    </message>
    <message>
        <source>&amp;English</source>
        <translation>English(&amp;E)</translation>
    </message>
    <message>
        <source>Speak English, from the next start on.</source>
        <translation>次の起動から英語を使います。</translation>
    </message>
    <message>
        <source>日本語 (&amp;Japanese)</source>
        <translation>日本語(&amp;J)</translation>
    </message>
    <message>
        <source>Speak Japanese, from the next start on.</source>
        <translation>次の起動から日本語を使います。</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>選択(&amp;S)</translation>
    </message>
    <message>
        <source>Select, move, resize and turn.</source>
        <translation>選択、移動、大きさの変更、回転。</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>長方形(&amp;R)</translation>
    </message>
    <message>
        <source>Draw a rectangular building.</source>
        <translation>長方形の建物を描きます。</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>多角形(&amp;P)</translation>
    </message>
    <message>
        <source>Draw a building of any shape.</source>
        <translation>自由な形の建物を描きます。</translation>
    </message>
    <message>
        <source>S&amp;tart</source>
        <translation>出発点(&amp;T)</translation>
    </message>
    <message>
        <source>Say where the robot starts and looks.</source>
        <translation>ロボットの出発点と見る方向を示します。</translation>
    </message>
    <message>
        <source>R&amp;oute</source>
        <translation>経路(&amp;O)</translation>
    </message>
    <message>
        <source>Draw the way that the robot shall take.</source>
        <translation>ロボットの通る道を描きます。</translation>
    </message>
    <message>
        <source>&amp;Landmark</source>
        <translation>目印(&amp;L)</translation>
    </message>
    <message>
        <source>Mark a place by name.</source>
        <translation>場所に名前付きの目印を付けます。</translation>
    </message>
    <message>
        <source>Ad&amp;just Picture</source>
        <translation>画像を調整(&amp;J)</translation>
    </message>
    <message>
        <source>Move, turn and scale a picture under the drawing.</source>
        <translation>図面の下の画像を移動、回転、拡大縮小します。</translation>
    </message>
    <message>
        <source>Add Picture &amp;Underneath…</source>
        <translation>下に敷く画像を追加(&amp;U)…</translation>
    </message>
    <message>
        <source>Draw upon an aerial photo, a plan or a photo of a sketch.</source>
        <translation>航空写真、平面図、スケッチの写真の上に描きます。</translation>
    </message>
    <message>
        <source>Open Re&amp;cording…</source>
        <translation>記録を開く(&amp;C)…</translation>
    </message>
    <message>
        <source>Take the robot&apos;s observations from a recording.</source>
        <translation>ロボットの観測を記録から取ります。</translation>
    </message>
    <message>
        <source>C&amp;onnect a Robot…</source>
        <translation>ロボットを接続(&amp;O)…</translation>
    </message>
    <message>
        <source>Put a live robot together: camera or scanner, head, wheels.</source>
        <translation>実機を構成します: カメラまたはスキャナー、雲台、車輪。</translation>
    </message>
    <message>
        <source>Si&amp;mulator</source>
        <translation>シミュレーター(&amp;M)</translation>
    </message>
    <message>
        <source>Take the robot&apos;s observations from the built-in simulator.</source>
        <translation>ロボットの観測を内蔵シミュレーターから取ります。</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>実行(&amp;R)</translation>
    </message>
    <message>
        <source>Localize on the drawing and correct it.</source>
        <translation>図面の上で位置を推定し、図面を補正します。</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>Hold after this observation.</source>
        <translation>この観測の後で止めます。</translation>
    </message>
    <message>
        <source>S&amp;tep</source>
        <translation>一歩(&amp;T)</translation>
    </message>
    <message>
        <source>Work in one observation, then hold.</source>
        <translation>観測を一つ処理して止めます。</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>End the run.</source>
        <translation>実行を終えます。</translation>
    </message>
    <message>
        <source>&amp;Accept Correction</source>
        <translation>補正を取り込む(&amp;A)</translation>
    </message>
    <message>
        <source>Take the corrected shapes into the drawing, as one step that can be undone.</source>
        <translation>補正した形を図面に取り込みます。一回で元に戻せます。</translation>
    </message>
    <message>
        <source>Show in your own images what is a building and what is not.</source>
        <translation>自分の画像で、建物とそうでないものを教えます。</translation>
    </message>
    <message>
        <source>&amp;Command Palette…</source>
        <translation>コマンドパレット(&amp;C)…</translation>
    </message>
    <message>
        <source>Find any command by a few letters.</source>
        <translation>数文字で任意のコマンドを探します。</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>キーボードショートカット(&amp;K)</translation>
    </message>
    <message>
        <source>Show and change every key.</source>
        <translation>すべてのキーを表示し、変更します。</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>ツアー(&amp;T)</translation>
    </message>
    <message>
        <source>Show in five steps where things are.</source>
        <translation>五段階で画面を案内します。</translation>
    </message>
    <message>
        <source>&amp;About Handmap</source>
        <translation>Handmap について(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licence.</source>
        <translation>版とライセンス。</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Draw</source>
        <translation>描画(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Step &amp;Back</source>
        <translation>一歩戻る(&amp;B)</translation>
    </message>
    <message>
        <source>Look at the observation before.</source>
        <translation>一つ前の観測を見ます。</translation>
    </message>
    <message>
        <source>To the Ne&amp;west</source>
        <translation>最新へ(&amp;W)</translation>
    </message>
    <message>
        <source>Look at how it is now, no longer at the past.</source>
        <translation>過去ではなく現在の状態を見ます。</translation>
    </message>
    <message>
        <source>Boo&amp;kmark This Moment</source>
        <translation>この時点をブックマーク(&amp;K)</translation>
    </message>
    <message>
        <source>Mark it on the timeline, or take the mark away.</source>
        <translation>タイムラインに印を付ける、または外します。</translation>
    </message>
    <message>
        <source>Ne&amp;xt Bookmark</source>
        <translation>次のブックマーク(&amp;X)</translation>
    </message>
    <message>
        <source>Look at the next moment that is marked.</source>
        <translation>印を付けた次の時点を見ます。</translation>
    </message>
    <message>
        <source>Recomp&amp;ute with the Drawing</source>
        <translation>この図面で計算し直す(&amp;U)</translation>
    </message>
    <message>
        <source>Do the run again, so far as it has come, with the drawing as it is now.</source>
        <translation>ここまでの実行を、今の図面でやり直します。</translation>
    </message>
    <message>
        <source>Robot Is &amp;Here…</source>
        <translation>ロボットはここ(&amp;H)…</translation>
    </message>
    <message>
        <source>Say where the robot is at the moment that is shown; the run is done again with it.</source>
        <translation>表示中の時点でロボットがいる場所を示します。それを使って実行をやり直します。</translation>
    </message>
    <message>
        <source>&amp;Forget Given Poses</source>
        <translation>指定した位置を忘れる(&amp;F)</translation>
    </message>
    <message>
        <source>Do the run again without the poses that you gave.</source>
        <translation>指定した位置を使わずに実行をやり直します。</translation>
    </message>
    <message>
        <source>Building Is Ri&amp;ght</source>
        <translation>建物は正しい(&amp;G)</translation>
    </message>
    <message>
        <source>Hold the selected buildings where the run shows them, and do it again with that.</source>
        <translation>選択した建物を実行の示す場所に固定して、やり直します。</translation>
    </message>
    <message>
        <source>Building Is &amp;Not There</source>
        <translation>建物は存在しない(&amp;N)</translation>
    </message>
    <message>
        <source>Take the selected buildings out of the drawing, and do the run again without them.</source>
        <translation>選択した建物を図面から除き、それなしで実行をやり直します。</translation>
    </message>
    <message>
        <source>Teach Bu&amp;ildings…</source>
        <translation>建物を教える(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;Keep as Template…</source>
        <translation>テンプレートとして保存(&amp;K)…</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>切り取り(&amp;T)</translation>
    </message>
    <message>
        <source>Put what is selected on the clipboard.</source>
        <translation>選択したものを切り取り、クリップボードに入れます。</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>Copy what is selected to the clipboard.</source>
        <translation>選択したものをクリップボードにコピーします。</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>Put what is on the clipboard where the pointer is.</source>
        <translation>クリップボードのものをポインターの位置に置きます。</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>複製(&amp;L)</translation>
    </message>
    <message>
        <source>Copy what is selected beside itself.</source>
        <translation>選択したものを隣に複製します。</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>名前を変更(&amp;N)</translation>
    </message>
    <message>
        <source>Type the name where the building is.</source>
        <translation>建物の場所で名前を入力します。</translation>
    </message>
    <message>
        <source>Add C&amp;orner</source>
        <translation>角を追加(&amp;O)</translation>
    </message>
    <message>
        <source>Put another corner into the wall or the route.</source>
        <translation>壁または経路に角を加えます。</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>ロック(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Square Up</source>
        <translation>直角に整える(&amp;S)</translation>
    </message>
    <message>
        <source>Make nearly right angles right, and what is nearly level level.</source>
        <translation>ほぼ直角のものを直角に、ほぼ水平のものを水平にします。</translation>
    </message>
    <message>
        <source>Make &amp;Parallel</source>
        <translation>平行にする(&amp;P)</translation>
    </message>
    <message>
        <source>Make P&amp;olygon</source>
        <translation>多角形にする(&amp;O)</translation>
    </message>
    <message>
        <source>So that each corner can be moved alone.</source>
        <translation>角を一つずつ動かせるようにします。</translation>
    </message>
    <message>
        <source>Align L&amp;eft</source>
        <translation>左をそろえる(&amp;E)</translation>
    </message>
    <message>
        <source>Lay the left sides on one line.</source>
        <translation>左の辺を一直線にそろえます。</translation>
    </message>
    <message>
        <source>Align &amp;Right</source>
        <translation>右をそろえる(&amp;R)</translation>
    </message>
    <message>
        <source>Lay the right sides on one line.</source>
        <translation>右の辺を一直線にそろえます。</translation>
    </message>
    <message>
        <source>Align &amp;Top</source>
        <translation>上をそろえる(&amp;T)</translation>
    </message>
    <message>
        <source>Lay the upper sides on one line.</source>
        <translation>上の辺を一直線にそろえます。</translation>
    </message>
    <message>
        <source>Align &amp;Bottom</source>
        <translation>下をそろえる(&amp;B)</translation>
    </message>
    <message>
        <source>Lay the lower sides on one line.</source>
        <translation>下の辺を一直線にそろえます。</translation>
    </message>
    <message>
        <source>Align &amp;Middles in a Column</source>
        <translation>中心を縦にそろえる(&amp;M)</translation>
    </message>
    <message>
        <source>Lay the middles above one another.</source>
        <translation>中心を上下に並べます。</translation>
    </message>
    <message>
        <source>Align M&amp;iddles in a Row</source>
        <translation>中心を横にそろえる(&amp;I)</translation>
    </message>
    <message>
        <source>Lay the middles beside one another.</source>
        <translation>中心を左右に並べます。</translation>
    </message>
    <message>
        <source>&amp;Distribute in a Row</source>
        <translation>横に等間隔(&amp;D)</translation>
    </message>
    <message>
        <source>Make the gaps from left to right equal.</source>
        <translation>左右の間隔を等しくします。</translation>
    </message>
    <message>
        <source>Distribute in a &amp;Column</source>
        <translation>縦に等間隔(&amp;C)</translation>
    </message>
    <message>
        <source>Make the gaps from bottom to top equal.</source>
        <translation>上下の間隔を等しくします。</translation>
    </message>
    <message>
        <source>Snap &amp;to Objects</source>
        <translation>物にスナップ(&amp;T)</translation>
    </message>
    <message>
        <source>Draw points to corners, walls, their lines and right angles; Alt holds it off.</source>
        <translation>点を角、壁、その延長線、直角に引き寄せます。Alt で止めます。</translation>
    </message>
    <message>
        <source>&amp;Next Way to Snap</source>
        <translation>スナップ方法を切り替え(&amp;N)</translation>
    </message>
    <message>
        <source>Objects, grid, both or neither in turn.</source>
        <translation>オブジェクト、格子、両方、なしを順に切り替えます。</translation>
    </message>
    <message>
        <source>Rectangle by &amp;Edge</source>
        <translation>辺から長方形(&amp;E)</translation>
    </message>
    <message>
        <source>Draw one wall at any angle, then the depth.</source>
        <translation>任意の角度で一つの壁を描き、次に奥行きを決めます。</translation>
    </message>
    <message>
        <source>Free&amp;hand</source>
        <translation>フリーハンド(&amp;H)</translation>
    </message>
    <message>
        <source>Draw around a building; the stroke is made straight.</source>
        <translation>建物の周りを描くと、線が整えられます。</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>計測(&amp;M)</translation>
    </message>
    <message>
        <source>Read lengths, angles and areas.</source>
        <translation>長さ、角度、面積を測ります。</translation>
    </message>
    <message>
        <source>Er&amp;aser</source>
        <translation>消しゴム(&amp;A)</translation>
    </message>
    <message>
        <source>Erase what a stroke touches.</source>
        <translation>線が触れたものを消します。</translation>
    </message>
    <message>
        <source>&amp;Guess Shapes of Strokes</source>
        <translation>線の形を推測(&amp;G)</translation>
    </message>
    <message>
        <source>Offer a rectangle, an L or a polygon for each freehand stroke.</source>
        <translation>フリーハンドの線ごとに、長方形、L 字形、多角形を提案します。</translation>
    </message>
    <message>
        <source>&amp;Arrange</source>
        <translation>配置(&amp;A)</translation>
    </message>
    <message>
        <source>Keep the robot in the middle; again: and turn the map as it looks; again: off.</source>
        <translation>ロボットを中央に保ちます。もう一度: ロボットの向きに地図を回します。もう一度: 切ります。</translation>
    </message>
    <message>
        <source>Wh&amp;y Is This Wall Here</source>
        <translation>この壁はなぜここに(&amp;Y)</translation>
    </message>
    <message>
        <source>Ask what placed a corrected wall: which observations, and how far each pulled.</source>
        <translation>補正した壁の位置を何が決めたか、どの観測がどれだけ引いたかを調べます。</translation>
    </message>
    <message>
        <source>Follo&amp;w the Robot</source>
        <translation>ロボットを追う(&amp;W)</translation>
    </message>
    <message>
        <source>Next Phas&amp;e</source>
        <translation>次の段階(&amp;E)</translation>
    </message>
    <message>
        <source>Work in one observation and go through it, phase by phase.</source>
        <translation>観測を 1 つ処理し、段階ごとに見ます。</translation>
    </message>
    <message>
        <source>Open Gi&amp;ven Poses…</source>
        <translation>既知の姿勢を開く(&amp;V)…</translation>
    </message>
    <message>
        <source>Lead the robot&apos;s way through known poses of a file (TUM form, metres of the map).</source>
        <translation>ファイルにある既知の姿勢 (TUM 形式、地図の座標) をロボットの軌跡が通るようにします。</translation>
    </message>
    <message>
        <source>Ca&amp;librate Cameras…</source>
        <translation>カメラの校正(&amp;L)…</translation>
    </message>
    <message>
        <source>Hold a checkerboard before a stereo camera, so that it measures.</source>
        <translation>ステレオカメラの前に市松模様の板をかざし、距離を測れるようにします。</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>手引き(&amp;G)</translation>
    </message>
    <message>
        <source>How everything is done, with pictures.</source>
        <translation>すべてのやり方を画像つきで説明します。</translation>
    </message>
    <message>
        <source>&amp;Import Log…</source>
        <translation>ログの取り込み(&amp;I)…</translation>
    </message>
    <message>
        <source>Make a recording of the log of another program.</source>
        <translation>ほかのプログラムのログから記録を作ります。</translation>
    </message>
    <message>
        <source>Open a drawing, OpenStreetMap or GeoJSON.</source>
        <translation>図面、OpenStreetMap、GeoJSON を開きます。</translation>
    </message>
    <message>
        <source>Save the plan with title, scale and legend: PNG, SVG or PDF.</source>
        <translation>表題・縮尺・凡例を付けて平面図を保存します（PNG、SVG、PDF）。</translation>
    </message>
    <message>
        <source>Turn by 90° L&amp;eft</source>
        <translation>左に 90° 回す(&amp;E)</translation>
    </message>
    <message>
        <source>Turn what is selected counter-clockwise.</source>
        <translation>選択したものを反時計回りに回します。</translation>
    </message>
    <message>
        <source>Turn by 90° Ri&amp;ght</source>
        <translation>右に 90° 回す(&amp;G)</translation>
    </message>
    <message>
        <source>Turn what is selected clockwise.</source>
        <translation>選択したものを時計回りに回します。</translation>
    </message>
    <message>
        <source>&amp;Mirror Left and Right</source>
        <translation>左右を反転(&amp;M)</translation>
    </message>
    <message>
        <source>Exchange left and right.</source>
        <translation>左と右を入れ替えます。</translation>
    </message>
    <message>
        <source>Mirror Top and &amp;Bottom</source>
        <translation>上下を反転(&amp;B)</translation>
    </message>
    <message>
        <source>Exchange top and bottom.</source>
        <translation>上と下を入れ替えます。</translation>
    </message>
    <message>
        <source>Arra&amp;y…</source>
        <translation>並べて複製(&amp;Y)…</translation>
    </message>
    <message>
        <source>Copy what is selected in columns and rows.</source>
        <translation>選択したものを列と行に並べて複製します。</translation>
    </message>
    <message>
        <source>It is not moved, resized or deleted by hand; again: unlock it.</source>
        <translation>手で動かしたり、大きさを変えたり、消したりできなくします。もう一度でロックを解除します。</translation>
    </message>
    <message>
        <source>Turn the selected to the direction of the largest of them; one alone to that of the nearest.</source>
        <translation>選択したものを、その中で最も大きい建物の向きにそろえます。一つだけなら最も近い建物の向きにします。</translation>
    </message>
    <message>
        <source>Side &amp;Panel</source>
        <translation>サイドパネル(&amp;P)</translation>
    </message>
    <message>
        <source>Show objects, layers and results beside the map.</source>
        <translation>オブジェクト、レイヤー、結果を地図の横に表示します。</translation>
    </message>
    <message>
        <source>Georeferen&amp;ce by Two Points</source>
        <translation>二点で地理座標を決める(&amp;C)</translation>
    </message>
    <message>
        <source>Say where the drawing lies on earth by two places that you know.</source>
        <translation>知っている二つの場所で、図面が地球上のどこにあるかを示します。</translation>
    </message>
    <message>
        <source>Simulate This &amp;Drawing</source>
        <translation>この図面でシミュレーション(&amp;D)</translation>
    </message>
    <message>
        <source>Let a simulated robot drive through what you have drawn.</source>
        <translation>描いた図面の中をシミュレーターのロボットに走らせます。</translation>
    </message>
    <message>
        <source>&amp;From Paper…</source>
        <translation>紙から(&amp;F)…</translation>
    </message>
    <message>
        <source>Make buildings of a photo of a drawing on paper.</source>
        <translation>紙に描いた図の写真から建物を作ります。</translation>
    </message>
    <message>
        <source>Print a S&amp;heet…</source>
        <translation>用紙を印刷(&amp;H)…</translation>
    </message>
    <message>
        <source>Make a page to draw on, whose photo tells scale and start.</source>
        <translation>描くための用紙を作ります。その写真から縮尺と出発点が分かります。</translation>
    </message>
    <message>
        <source>Compare &amp;Drawings…</source>
        <translation>図面を比べる(&amp;D)…</translation>
    </message>
    <message>
        <source>Tell by figures and arrows how far the drawing is off a true map.</source>
        <translation>図面が正しい地図からどれだけずれているかを、数値と矢印で示します。</translation>
    </message>
    <message>
        <source>Export to Other Pro&amp;grams…</source>
        <translation>ほかのプログラムに書き出す(&amp;G)…</translation>
    </message>
    <message>
        <source>Save the map as GeoJSON, OpenStreetMap, KML, GeoPackage, DXF or for robots.</source>
        <translation>地図を GeoJSON、OpenStreetMap、KML、GeoPackage、DXF、またはロボット用に保存します。</translation>
    </message>
    <message>
        <source>&amp;Export Report…</source>
        <translation>レポートを書き出す(&amp;E)…</translation>
    </message>
    <message>
        <source>Make a page of the run that anybody can open.</source>
        <translation>実行から、誰でも開ける一つのページを作ります。</translation>
    </message>
    <message>
        <source>Export R&amp;un as MCAP…</source>
        <translation>実行を MCAP で書き出す(&amp;M)…</translation>
    </message>
    <message>
        <source>Save the moments of the run for Rerun, Foxglove or RViz 2.</source>
        <translation>実行の各時点を Rerun、Foxglove、RViz 2 のために保存します。</translation>
    </message>
    <message>
        <source>Open Camera…</source>
        <translation>カメラを開く…</translation>
    </message>
    <message>
        <source>Watch a printed sheet while somebody draws on it.</source>
        <translation>印刷した用紙に描く様子をカメラで見て取り込みます。</translation>
    </message>
    <message>
        <source>Export Run as Fi&amp;lm…</source>
        <translation>実行を動画で書き出す(&amp;L)…</translation>
    </message>
    <message>
        <source>Save the moments of the run as a video of the map.</source>
        <translation>実行の各時点を地図の動画として保存します。</translation>
    </message>
    <message>
        <source>E&amp;xport Recording…</source>
        <translation>記録を書き出す(&amp;X)…</translation>
    </message>
    <message>
        <source>Save what the robot meets, and what was said, as a recording.</source>
        <translation>ロボットが見たものと、述べたことを記録として保存します。</translation>
    </message>
</context>
<context>
    <name>FigureWords</name>
    <message>
        <source>In the true map</source>
        <translation>正しい地図にある数</translation>
    </message>
    <message>
        <source>How many buildings and landmarks the true map has.</source>
        <translation>正しい地図にある建物と目印の数です。</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>描かれた数</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>描かれていない数</translation>
    </message>
    <message>
        <source>How many of them are not in the drawing.</source>
        <translation>そのうち、図面にないものの数です。</translation>
    </message>
    <message>
        <source>Only in the drawing</source>
        <translation>図面だけにある数</translation>
    </message>
    <message>
        <source>How many are drawn that the true map does not have.</source>
        <translation>描かれているのに正しい地図にはないものの数です。</translation>
    </message>
    <message>
        <source>Completeness</source>
        <translation>完全性</translation>
    </message>
    <message>
        <source>The share of the true map that is drawn: 1 is all.</source>
        <translation>正しい地図のうち描かれている割合です。1 ならすべてです。</translation>
    </message>
    <message>
        <source>Drawn as one with others</source>
        <translation>ほかと一つに描かれた数</translation>
    </message>
    <message>
        <source>How many true buildings are missing where a drawn one covers their place.</source>
        <translation>描かれておらず、その場所を描かれた別の建物が覆っている建物の数です。</translation>
    </message>
    <message>
        <source>Stood for by a few</source>
        <translation>少数で代表された数</translation>
    </message>
    <message>
        <source>How many true buildings a few drawn ones stand for. Only known of sketches with an alignment file, else 0.</source>
        <translation>少数の描かれた建物が代わりに表している建物の数です。対応表のある略図だけで分かり、ほかでは 0 です。</translation>
    </message>
    <message>
        <source>Drawn as a point</source>
        <translation>点で描かれた数</translation>
    </message>
    <message>
        <source>How many true buildings are a mere point in the drawing. Only known of sketches with an alignment file, else 0.</source>
        <translation>図面ではただの点になっている建物の数です。対応表のある略図だけで分かり、ほかでは 0 です。</translation>
    </message>
    <message>
        <source>Overlap (IoU)</source>
        <translation>重なり (IoU)</translation>
    </message>
    <message>
        <source>How far the drawn and the true outline of a building cover each other as they lie, on average: 1 is the same outline, 0 is beside it.</source>
        <translation>建物の描かれた輪郭と正しい輪郭が、今の位置のままでどれだけ重なるかの平均です。1 は同じ輪郭、0 はまったく重ならないことを表します。</translation>
    </message>
    <message>
        <source>Correlation r</source>
        <translation>相関 r</translation>
    </message>
    <message>
        <source>How alike the places of both maps are once the true map is laid on the drawing: 1 is the same, 0 is nothing alike.</source>
        <translation>正しい地図を図面に重ね合わせたとき、両方の位置がどれだけ似ているかです。1 は同じ、0 はまったく似ていないことを表します。</translation>
    </message>
    <message>
        <source>Explained share r²</source>
        <translation>説明される割合 r²</translation>
    </message>
    <message>
        <source>The share of the spread of the drawn places that follows from the true ones.</source>
        <translation>描かれた位置のばらつきのうち、正しい位置から説明できる割合です。</translation>
    </message>
    <message>
        <source>Turn θ</source>
        <translation>回転 θ</translation>
    </message>
    <message>
        <source>How far the drawing as a whole is turned, counter-clockwise.</source>
        <translation>図面全体が反時計回りにどれだけ回っているかです。</translation>
    </message>
    <message>
        <source>Scale along x</source>
        <translation>x 方向の倍率</translation>
    </message>
    <message>
        <source>The width of the drawing as a multiple of the true one: above 1 it is drawn too large.</source>
        <translation>図面の幅が正しい幅の何倍かです。1 より大きければ大きく描きすぎています。</translation>
    </message>
    <message>
        <source>Scale along y</source>
        <translation>y 方向の倍率</translation>
    </message>
    <message>
        <source>The height of the drawing as a multiple of the true one: above 1 it is drawn too large.</source>
        <translation>図面の高さが正しい高さの何倍かです。1 より大きければ大きく描きすぎています。</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>せん断</translation>
    </message>
    <message>
        <source>How far what is upright leans to the right in the drawing: 0 is not at all.</source>
        <translation>まっすぐ上に伸びるものが図面でどれだけ右に傾くかです。0 なら傾きません。</translation>
    </message>
    <message>
        <source>Shift along x</source>
        <translation>x 方向のずれ</translation>
    </message>
    <message>
        <source>How far to the right the origin of the true map comes to lie in the drawing.</source>
        <translation>正しい地図の原点が、図面ではどれだけ右に来るかです。</translation>
    </message>
    <message>
        <source>Shift along y</source>
        <translation>y 方向のずれ</translation>
    </message>
    <message>
        <source>How far up the origin of the true map comes to lie in the drawing.</source>
        <translation>正しい地図の原点が、図面ではどれだけ上に来るかです。</translation>
    </message>
    <message>
        <source>Distortion D</source>
        <translation>ゆがみ D</translation>
    </message>
    <message>
        <source>What is left between both maps once one is laid on the other: the root of the sum of all squared distances.</source>
        <translation>両方の地図を重ね合わせたあとに残るずれです。距離の二乗の和の平方根です。</translation>
    </message>
    <message>
        <source>Greatest distortion D max</source>
        <translation>最大のゆがみ D max</translation>
    </message>
    <message>
        <source>What would be left if the drawing had nothing of the true map.</source>
        <translation>図面が正しい地図とまったく無関係なら残るはずのずれです。</translation>
    </message>
    <message>
        <source>Distortion index</source>
        <translation>ゆがみ指数</translation>
    </message>
    <message>
        <source>Distortion as a share of the greatest one: 0 is none, 1 is a drawing that has nothing of the true map.</source>
        <translation>最大のゆがみに対する割合です。0 はゆがみなし、1 は正しい地図と無関係な図面です。</translation>
    </message>
    <message>
        <source>Test value F</source>
        <translation>検定量 F</translation>
    </message>
    <message>
        <source>How much follows from the true map against what does not: the larger, the less it is by chance.</source>
        <translation>正しい地図から説明できる分と、できない分の比です。大きいほど偶然ではありません。</translation>
    </message>
    <message>
        <source>Degrees of freedom of the fit</source>
        <translation>当てはめの自由度</translation>
    </message>
    <message>
        <source>How many numbers lay one map on the other, beside the shift.</source>
        <translation>ずれのほかに、地図を重ね合わせるのに使う数の個数です。</translation>
    </message>
    <message>
        <source>Degrees of freedom left</source>
        <translation>残りの自由度</translation>
    </message>
    <message>
        <source>How many coordinates are left to test it, once those numbers and the shift are taken away.</source>
        <translation>それらの数とずれの分を除いて、検定に残る座標の個数です。</translation>
    </message>
    <message>
        <source>Probability p</source>
        <translation>確率 p</translation>
    </message>
    <message>
        <source>How likely so large an F is by chance alone: below 0.05 is usually taken as not by chance.</source>
        <translation>これほど大きな F が偶然だけで出る確率です。ふつう 0.05 未満なら偶然ではないとみなします。</translation>
    </message>
    <message>
        <source>Information criterion (AIC)</source>
        <translation>情報量規準 (AIC)</translation>
    </message>
    <message>
        <source>Whether the true map tells where things are drawn, against no relation at all: below 0 it does.</source>
        <translation>無関係とするのに比べて、描かれた位置が正しい地図から分かるかどうかです。0 未満なら分かります。</translation>
    </message>
    <message>
        <source>Gain over one scale: F</source>
        <translation>倍率一つに対する改善: F</translation>
    </message>
    <message>
        <source>How much more follows once the drawing may be stretched and sheared too: the larger, the more.</source>
        <translation>図面の引き伸ばしとせん断も許すと、どれだけ多く説明できるかです。大きいほど多く説明できます。</translation>
    </message>
    <message>
        <source>Gain over one scale: p</source>
        <translation>倍率一つに対する改善: p</translation>
    </message>
    <message>
        <source>How likely so large a gain is by chance alone.</source>
        <translation>これほどの改善が偶然だけで出る確率です。</translation>
    </message>
    <message>
        <source>Gain over one scale: AIC</source>
        <translation>倍率一つに対する改善: AIC</translation>
    </message>
    <message>
        <source>Whether stretch and shear are worth two more numbers: below 0 they are.</source>
        <translation>引き伸ばしとせん断のために数を二つ増やす値打ちがあるかどうかです。0 未満ならあります。</translation>
    </message>
    <message>
        <source>Canonical organisation</source>
        <translation>方位関係の構成</translation>
    </message>
    <message>
        <source>The share of pairs in which the right one is the northern and the right one the eastern; what is missing counts as wrong.</source>
        <translation>二つずつの組のうち、どちらが北か、どちらが東かが合っている割合です。描かれていないものは誤りとします。</translation>
    </message>
    <message>
        <source>Canonical organisation, root</source>
        <translation>方位関係の構成の平方根</translation>
    </message>
    <message>
        <source>Its square root, which can be held against the completeness.</source>
        <translation>その平方根です。完全性と比べられます。</translation>
    </message>
    <message>
        <source>Canonical accuracy</source>
        <translation>方位関係の正確さ</translation>
    </message>
    <message>
        <source>The same of those pairs alone that are drawn.</source>
        <translation>描かれている組だけについての同じ割合です。</translation>
    </message>
    <message>
        <source>Canonical accuracy, root</source>
        <translation>方位関係の正確さの平方根</translation>
    </message>
    <message>
        <source>Its square root.</source>
        <translation>その平方根です。</translation>
    </message>
    <message>
        <source>Distance accuracy</source>
        <translation>距離の正確さ</translation>
    </message>
    <message>
        <source>How right the distances from one to another are, whatever the scale: 1 is right.</source>
        <translation>倍率によらず、互いの距離がどれだけ合っているかです。1 なら正しい距離です。</translation>
    </message>
    <message>
        <source>Scaling bias</source>
        <translation>距離の偏り</translation>
    </message>
    <message>
        <source>Above 0: short distances are drawn too long beside the longest one; below 0: too short.</source>
        <translation>0 より大きければ、最も長い距離に比べて短い距離が長く描かれ、0 より小さければ短く描かれています。</translation>
    </message>
    <message>
        <source>Angle accuracy</source>
        <translation>方向の正確さ</translation>
    </message>
    <message>
        <source>How right the directions from one to another are: 1 is right.</source>
        <translation>互いの方向がどれだけ合っているかです。1 なら正しい方向です。</translation>
    </message>
    <message>
        <source>Rotational bias</source>
        <translation>回転の偏り</translation>
    </message>
    <message>
        <source>How far directions from one to another are turned on average, counter-clockwise.</source>
        <translation>互いの方向が平均で反時計回りにどれだけ回っているかです。</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>描かれたもの</translation>
    </message>
    <message>
        <source>Laid on it by shift, turn and one scale (Euclidean)</source>
        <translation>ずれ、回転、倍率一つで重ねたとき（ユークリッド）</translation>
    </message>
    <message>
        <source>Stretched and sheared too (affine)</source>
        <translation>引き伸ばしとせん断も許したとき（アフィン）</translation>
    </message>
    <message>
        <source>From one to another</source>
        <translation>互いの位置関係</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>How many of them are in the drawing, by the same id.</source>
        <translation>そのうち、同じ id で図面にあるものの数です。</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Sketch of %1</source>
        <translation>%1 のスケッチ</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>デモ</translation>
    </message>
    <message>
        <source>two rows</source>
        <translation>二列の建物</translation>
    </message>
    <message>
        <source>a campus</source>
        <translation>キャンパス</translation>
    </message>
    <message>
        <source>around a campus</source>
        <translation>キャンパス一周</translation>
    </message>
    <message>
        <source>this drawing</source>
        <translation>この図面</translation>
    </message>
    <message>
        <source>Waiting for the robot</source>
        <translation>ロボットを待っています</translation>
    </message>
    <message>
        <source>Virtual rig</source>
        <translation>仮想ロボット</translation>
    </message>
    <message>
        <source>1 building</source>
        <translation>建物 1 棟</translation>
    </message>
    <message>
        <source>%1 buildings</source>
        <translation>建物 %1 棟</translation>
    </message>
    <message>
        <source>1 taught image</source>
        <translation>教示画像 1 枚</translation>
    </message>
    <message>
        <source>%1 taught images</source>
        <translation>教示画像 %1 枚</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Simulator: %1</source>
        <translation>シミュレーター: %1</translation>
    </message>
    <message>
        <source>Rendering what the cameras see</source>
        <translation>カメラ画像を描画しています</translation>
    </message>
    <message>
        <source>buildings along x %1 → %2 m</source>
        <translation>建物の x 方向 %1 → %2 m</translation>
    </message>
    <message>
        <source>front walls %1 → %2 m</source>
        <translation>正面の壁 %1 → %2 m</translation>
    </message>
    <message>
        <source>widths %1 → %2 m</source>
        <translation>幅 %1 → %2 m</translation>
    </message>
    <message>
        <source>way of the robot %1 → %2 m</source>
        <translation>ロボットの軌跡 %1 → %2 m</translation>
    </message>
    <message>
        <source>Mean errors, before → after: %1</source>
        <translation>平均誤差、補正前 → 補正後: %1</translation>
    </message>
    <message numerus="yes">
        <source>mean error of %n building(s)</source>
        <translation>
            <numerusform>建物 %n 棟の平均誤差</numerusform>
        </translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>描いたもの</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>補正後</translation>
    </message>
    <message>
        <source>error of the robot&apos;s way</source>
        <translation>ロボットの軌跡の誤差</translation>
    </message>
    <message>
        <source>odometry</source>
        <translation>オドメトリ</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 を回転</translation>
    </message>
    <message>
        <source>Resize %1</source>
        <translation>%1 の大きさを変更</translation>
    </message>
    <message>
        <source>Turn Start</source>
        <translation>出発点の向きを変更</translation>
    </message>
    <message>
        <source>Bend Route</source>
        <translation>経路を曲げる</translation>
    </message>
    <message>
        <source>%1 Objects</source>
        <translation>%1 個のオブジェクト</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 を移動</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m</source>
        <translation>x %1 m、y %2 m</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>出発点</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>経路</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>ファイルではありません</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>no picture, or one of an unknown format</source>
        <translation>画像ではないか、未知の形式です</translation>
    </message>
    <message>
        <source>a picture without pixels</source>
        <translation>画素のない画像です</translation>
    </message>
    <message>
        <source>no picture of a known format</source>
        <translation>既知の形式の画像ではありません</translation>
    </message>
    <message>
        <source>%1 × %2 pixels are too many; cut out the place that is drawn</source>
        <translation>%1 × %2 画素は多すぎます。描く場所だけを切り出してください</translation>
    </message>
    <message>
        <source>there is not enough memory for it</source>
        <translation>メモリが足りません</translation>
    </message>
    <message>
        <source>this program was built without GDAL, which reads such pictures</source>
        <translation>このプログラムは、この種の画像を読む GDAL なしで作られています</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>角</translation>
    </message>
    <message>
        <source>crossing</source>
        <translation>交点</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>right angle</source>
        <translation>直角</translation>
    </message>
    <message>
        <source>in line</source>
        <translation>延長線上</translation>
    </message>
    <message>
        <source>Snap: objects, grid</source>
        <translation>スナップ: オブジェクト、格子</translation>
    </message>
    <message>
        <source>Snap: grid</source>
        <translation>スナップ: 格子</translation>
    </message>
    <message>
        <source>Snap: objects</source>
        <translation>スナップ: オブジェクト</translation>
    </message>
    <message>
        <source>Snap: off</source>
        <translation>スナップ: なし</translation>
    </message>
    <message>
        <source>Add Corner</source>
        <translation>角を追加</translation>
    </message>
    <message>
        <source>Move Corner</source>
        <translation>角を移動</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>L-shape</source>
        <translation>L 字形</translation>
    </message>
    <message>
        <source>Polygon of %1 corners</source>
        <translation>%1 角形</translation>
    </message>
    <message>
        <source>at the left edge</source>
        <translation>左端に</translation>
    </message>
    <message>
        <source>at the right edge</source>
        <translation>右端に</translation>
    </message>
    <message>
        <source>at the top edge</source>
        <translation>上端に</translation>
    </message>
    <message>
        <source>at the bottom edge</source>
        <translation>下端に</translation>
    </message>
    <message>
        <source>near: half as wide as the image</source>
        <translation>近くに：画像の幅の半分</translation>
    </message>
    <message>
        <source>far: a quarter of the image</source>
        <translation>遠くに：画像の4分の1</translation>
    </message>
    <message>
        <source>turned, its left side nearer</source>
        <translation>回して、左側を手前に</translation>
    </message>
    <message>
        <source>turned, its right side nearer</source>
        <translation>回して、右側を手前に</translation>
    </message>
    <message>
        <source>tilted, its top nearer</source>
        <translation>傾けて、上側を手前に</translation>
    </message>
    <message>
        <source>tilted, its bottom nearer</source>
        <translation>傾けて、下側を手前に</translation>
    </message>
    <message>
        <source>Move or tilt it: any new view helps.</source>
        <translation>動かすか傾けてください。新しい向きなら何でも役に立ちます。</translation>
    </message>
    <message>
        <source>Next: %1.</source>
        <translation>次：%1。</translation>
    </message>
    <message>
        <source>No whole board is seen.</source>
        <translation>板の全体が見えません。</translation>
    </message>
    <message>
        <source>Only one camera sees the whole board.</source>
        <translation>板の全体が片方のカメラにしか見えません。</translation>
    </message>
    <message>
        <source>Hold still.</source>
        <translation>動かさないでください。</translation>
    </message>
    <message>
        <source>Not sharp: more light, or hold it stiller.</source>
        <translation>ぼけています。もっと明るくするか、じっと持ってください。</translation>
    </message>
    <message>
        <source>Taken.</source>
        <translation>撮りました。</translation>
    </message>
    <message>
        <source>Found with %1 pairs: the corners are off by %2 px in the left and %3 px in the right image, rows by %4 px. Baseline %5 m, focal length %6 px. What lies on a line on the left lies on it on the right.</source>
        <translation>%1 組から求めました。角のずれは左の画像で %2 px、右の画像で %3 px、行のずれは %4 px です。基線長 %5 m、焦点距離 %6 px。左で線の上にあるものは、右でも同じ線の上にあります。</translation>
    </message>
    <message>
        <source>there is not enough memory for the picture</source>
        <translation>画像のためのメモリーが足りません</translation>
    </message>
    <message>
        <source>%1: cannot be encoded as PNG</source>
        <translation>%1: PNG として符号化できません</translation>
    </message>
    <message>
        <source>the clipboard holds too much for a drawing</source>
        <translation>クリップボードの内容は図面には多すぎます</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>クリップボード</translation>
    </message>
    <message>
        <source>runs of windows such as %1</source>
        <translation>%1 のような窓の並び</translation>
    </message>
    <message>
        <source>a quarter</source>
        <translation>街区</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>Replace?</source>
        <translation>置き換えますか?</translation>
    </message>
    <message>
        <source>“%1” is there already.</source>
        <translation>「%1」はすでにあります。</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>置き換える(&amp;R)</translation>
    </message>
</context>
<context>
    <name>TimeLeft</name>
    <message numerus="yes">
        <source>, about %n second(s) left</source>
        <translation>
            <numerusform>、残り約 %n 秒</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, about %n minute(s) left</source>
        <translation>
            <numerusform>、残り約 %n 分</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>{}: cannot be written: {}</source>
        <translation>{}: 書き込めません: {}</translation>
    </message>
    <message>
        <source>{}: found {}, expected {}</source>
        <translation>{}: {} (必要: {})</translation>
    </message>
    <message>
        <source>{}: {}: found {}, expected {}</source>
        <translation>{}: {}: {} (必要: {})</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>停止しました</translation>
    </message>
    <message>
        <source>more than {} levels of nesting</source>
        <translation>{} 段を超える入れ子</translation>
    </message>
    <message>
        <source>fewer</source>
        <translation>より少ない数</translation>
    </message>
    <message>
        <source>this key twice in one object</source>
        <translation>一つのオブジェクトに同じキーが二度</translation>
    </message>
    <message>
        <source>each key once</source>
        <translation>各キーは一度だけ</translation>
    </message>
    <message>
        <source>more than {} values</source>
        <translation>{} 個を超える値</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>an array of {}</source>
        <translation>要素 {} 個の配列</translation>
    </message>
    <message>
        <source>{}{} (string)</source>
        <translation>{}{} (文字列)</translation>
    </message>
    <message>
        <source>{}: line {}, column {}: no valid JSON: {}</source>
        <translation>{}: {} 行 {} 列: 正しい JSON ではありません: {}</translation>
    </message>
    <message>
        <source>line {}</source>
        <translation>{} 行目</translation>
    </message>
    <message>
        <source>a number too large to represent</source>
        <translation>大きすぎて表せない数</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>有限の数</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>this key</source>
        <translation>このキー</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>配列</translation>
    </message>
    <message>
        <source>at most {}</source>
        <translation>{} 以下</translation>
    </message>
    <message>
        <source>a number from {} to {}</source>
        <translation>{} から {} までの数</translation>
    </message>
    <message>
        <source>a number &gt; 0 and at most {}</source>
        <translation>0 より大きく {} 以下の数</translation>
    </message>
    <message>
        <source>a whole number from {} to {}</source>
        <translation>{} から {} までの整数</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>a string of {} bytes</source>
        <translation>{} バイトの文字列</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true または false</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>a readable file</source>
        <translation>読み取れるファイル</translation>
    </message>
    <message>
        <source>no regular file</source>
        <translation>通常のファイルではありません</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>{} bytes</source>
        <translation>{} バイト</translation>
    </message>
    <message>
        <source>at most {} bytes</source>
        <translation>{} バイト以下</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>an image of {} × {} pixels</source>
        <translation>{} × {} 画素の画像</translation>
    </message>
    <message>
        <source>{} × {} as the images before</source>
        <translation>これまでの画像と同じ {} × {}</translation>
    </message>
    <message>
        <source>no such folder</source>
        <translation>フォルダーがありません</translation>
    </message>
    <message>
        <source>a folder of images</source>
        <translation>画像のフォルダー</translation>
    </message>
    <message>
        <source>no images</source>
        <translation>画像がありません</translation>
    </message>
    <message>
        <source>PNG or JPEG images</source>
        <translation>PNG または JPEG の画像</translation>
    </message>
    <message>
        <source>{}: found {} × {} pixels, expected {} × {} as the images before</source>
        <translation>{}: {} × {} 画素 (必要: これまでの画像と同じ {} × {})</translation>
    </message>
    <message>
        <source>no whole board of {} × {} corners in the {} image</source>
        <translation>{2}の画像に {0} × {1} の角を持つ板の全体が写っていません</translation>
    </message>
    <message>
        <source>no image of that name in the right folder</source>
        <translation>右のフォルダーに同じ名前の画像がありません</translation>
    </message>
    <message>
        <source>no image of that name in the left folder</source>
        <translation>左のフォルダーに同じ名前の画像がありません</translation>
    </message>
    <message>
        <source>no image of the same name as one in {}</source>
        <translation>{} の画像と同じ名前の画像がありません</translation>
    </message>
    <message>
        <source>both images of a pair with one name</source>
        <translation>組の二枚の画像に同じ名前</translation>
    </message>
    <message>
        <source>{}: found {} pairs that show the whole board, expected at least {}{}</source>
        <translation>{}: 板の全体が写った組は {} 組 (必要: {} 組以上){}</translation>
    </message>
    <message>
        <source>; the first refused, {}: {}</source>
        <translation>。最初に除いた {}: {}</translation>
    </message>
    <message>
        <source>take 15 to 30 pairs, the board near and far, tilted and turned, in all corners; is the number of inner corners right?</source>
        <translation>板を近くと遠く、傾けたり回したり、画面の隅々に置いて、15 から 30 組を撮影してください。内側の角の数は正しいですか?</translation>
    </message>
    <message>
        <source>tilt the board to both sides and up and down, by 20 to 40 degrees</source>
        <translation>板を左右と上下に 20 から 40 度傾けてください</translation>
    </message>
    <message>
        <source>{}: {} camera: found boards turned by at most {:.0f}° to each other, expected {:.0f}° or more: the focal length cannot be told</source>
        <translation>{}: {}カメラ: 板どうしの傾きの差は最大 {:.0f}° (必要: {:.0f}° 以上)。焦点距離を求められません</translation>
    </message>
    <message>
        <source>{}: {} camera: found a focal length known to ±{:.1f} %, expected ±{:g} % or better</source>
        <translation>{}: {}カメラ: 焦点距離の精度は ±{:.1f} % (必要: ±{:g} % 以内)</translation>
    </message>
    <message>
        <source>off by {:.2f} px, the others by {:.2f} px</source>
        <translation>ずれは {:.2f} px、ほかの組は {:.2f} px</translation>
    </message>
    <message>
        <source>an error of the left camera</source>
        <translation>左カメラの誤差</translation>
    </message>
    <message>
        <source>an error of the right camera</source>
        <translation>右カメラの誤差</translation>
    </message>
    <message>
        <source>an error between the rows of rectified images</source>
        <translation>平行化した画像の行の間の誤差</translation>
    </message>
    <message>
        <source>{}: found {} of {:.2f} px, expected at most {:g} px</source>
        <translation>{}: {} {:.2f} px (必要: {:g} px 以下)</translation>
    </message>
    <message>
        <source>sharp images, both of a pair taken at one time, of a board that is flat</source>
        <translation>平らな板を、鮮明に、組の二枚を同時に撮影してください</translation>
    </message>
    <message>
        <source>boards that fit no camera ({})</source>
        <translation>どのカメラにも合わない板 ({})</translation>
    </message>
    <message>
        <source>a flat checkerboard seen from several sides</source>
        <translation>さまざまな方向から見た平らな市松模様の板</translation>
    </message>
    <message>
        <source>building classifier</source>
        <translation>建物の識別器</translation>
    </message>
    <message>
        <source>wanted windows</source>
        <translation>求める窓</translation>
    </message>
    <message>
        <source>{} numbers</source>
        <translation>{} 個の数</translation>
    </message>
    <message>
        <source>{} or {}</source>
        <translation>{} または {}</translation>
    </message>
    <message>
        <source>at least one tree</source>
        <translation>一つ以上の木</translation>
    </message>
    <message>
        <source>three a node</source>
        <translation>節ごとに三つ</translation>
    </message>
    <message>
        <source>at least one vector</source>
        <translation>一つ以上のベクトル</translation>
    </message>
    <message>
        <source>{}; train the model again</source>
        <translation>{}。モデルを学習し直してください</translation>
    </message>
    <message>
        <source>3 numbers: red, green, blue</source>
        <translation>三つの数: 赤、緑、青</translation>
    </message>
    <message>
        <source>&quot;width&quot; and &quot;height&quot;, or neither</source>
        <translation>&quot;width&quot; と &quot;height&quot; の両方、またはどちらもなし</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>a network in ONNX form</source>
        <translation>ONNX 形式のネットワーク</translation>
    </message>
    <message>
        <source>{}: found no number of its class for buildings</source>
        <translation>{}: 建物のクラスの番号がありません</translation>
    </message>
    <message>
        <source>give it: --building-class N, or {{&quot;building_class&quot;: N}} in {}</source>
        <translation>指定してください: --building-class N、または {} の中に {{&quot;building_class&quot;: N}}</translation>
    </message>
    <message>
        <source>{}: cannot take an image of {}×{}: {}</source>
        <translation>{}: {}×{} の画像を受け付けません: {}</translation>
    </message>
    <message>
        <source>a network that insists on a size needs &quot;width&quot; and &quot;height&quot; in its .json</source>
        <translation>決まった大きさを求めるネットワークには、その .json に &quot;width&quot; と &quot;height&quot; が必要です</translation>
    </message>
    <message>
        <source>1×classes×rows×columns with a class {}</source>
        <translation>クラス {} を含む 1×クラス×行×列</translation>
    </message>
    <message>
        <source>image</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>{}×{} with {} channels</source>
        <translation>{}×{}、{} チャンネル</translation>
    </message>
    <message>
        <source>8 bit, one or three channels, at least 16×16</source>
        <translation>8 ビット、1 または 3 チャンネル、16×16 以上</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>数ではありません</translation>
    </message>
    <message>
        <source>scores</source>
        <translation>スコア</translation>
    </message>
    <message>
        <source>of buildings</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>of others</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>training images</source>
        <translation>学習用の画像</translation>
    </message>
    <message>
        <source>{} windows {}</source>
        <translation>{1}の窓が {0} 個</translation>
    </message>
    <message>
        <source>at least {}</source>
        <translation>{} 以上</translation>
    </message>
    <message>
        <source>more than {} windows</source>
        <translation>{} 個を超える窓</translation>
    </message>
    <message>
        <source>{} channels of {} bits</source>
        <translation>{1} ビットのチャンネルが {0} 個</translation>
    </message>
    <message>
        <source>1 or 3 channels of 8 bits</source>
        <translation>8 ビットのチャンネルが 1 個または 3 個</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>グレー</translation>
    </message>
    <message>
        <source>colour, or a model for grey images</source>
        <translation>カラー、またはグレー画像用のモデル</translation>
    </message>
    <message>
        <source>{} × {} pixels</source>
        <translation>{} × {} 画素</translation>
    </message>
    <message>
        <source>at least {0} × {0}</source>
        <translation>{0} × {0} 以上</translation>
    </message>
    <message>
        <source>georeference: found nothing, expected where the map lies</source>
        <translation>位置情報: なし (必要: 地図のある場所)</translation>
    </message>
    <message>
        <source>give the map a georeference before exporting it as GeoJSON</source>
        <translation>GeoJSON に書き出す前に、地図に位置情報を与えてください</translation>
    </message>
    <message>
        <source>the map has no building, expected at least one</source>
        <translation>地図に建物がありません (必要: 一つ以上)</translation>
    </message>
    <message>
        <source>draw the buildings that the robot will pass</source>
        <translation>ロボットが通る道沿いの建物を描いてください</translation>
    </message>
    <message>
        <source>the map has no start pose, expected one</source>
        <translation>地図に出発位置がありません</translation>
    </message>
    <message>
        <source>set where the robot starts and where it looks</source>
        <translation>ロボットの出発位置と向きを決めてください</translation>
    </message>
    <message>
        <source>a string that is not empty</source>
        <translation>空でない文字列</translation>
    </message>
    <message>
        <source>{} different vertices</source>
        <translation>異なる頂点 {} 個</translation>
    </message>
    <message>
        <source>3 to {}</source>
        <translation>3 から {}</translation>
    </message>
    <message>
        <source>a polygon without area</source>
        <translation>面積のない多角形</translation>
    </message>
    <message>
        <source>some area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>a polygon that meets itself</source>
        <translation>自分自身と接する多角形</translation>
    </message>
    <message>
        <source>a simple polygon</source>
        <translation>単純な多角形</translation>
    </message>
    <message>
        <source>&quot;rectangle&quot; or &quot;polygon&quot;</source>
        <translation>&quot;rectangle&quot; または &quot;polygon&quot;</translation>
    </message>
    <message>
        <source>{}: version: found {}, this program reads up to {}</source>
        <translation>{}: バージョン {} です。このプログラムが読めるのは {} までです</translation>
    </message>
    <message>
        <source>update the program to open this map</source>
        <translation>この地図を開くにはプログラムを更新してください</translation>
    </message>
    <message>
        <source>{}, the id of {}</source>
        <translation>{1} の ID である {0}</translation>
    </message>
    <message>
        <source>an id that is unique in the file</source>
        <translation>ファイルの中で一意の ID</translation>
    </message>
    <message>
        <source>{} vertices up to here</source>
        <translation>ここまでに頂点 {} 個</translation>
    </message>
    <message>
        <source>at most {} in all</source>
        <translation>合計 {} 以下</translation>
    </message>
    <message>
        <source>the map holds a number that is not finite</source>
        <translation>地図に有限でない数が含まれています</translation>
    </message>
    <message>
        <source>a path relative to the folder of the map</source>
        <translation>地図のフォルダーからの相対パス</translation>
    </message>
    <message>
        <source>{}: {}: found {}{}, expected {}</source>
        <translation>{}: {}: {}{} (必要: {})</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>ファイルのパス</translation>
    </message>
    <message>
        <source>, outside of the folder of the map</source>
        <translation>、地図のフォルダーの外</translation>
    </message>
    <message>
        <source>a file in that folder</source>
        <translation>そのフォルダーの中のファイル</translation>
    </message>
    <message>
        <source>put it beside the map, or allow what lies outside (--allow-outside) if you trust the map</source>
        <translation>地図と同じフォルダーに置くか、地図を信頼できる場合はフォルダーの外も許可してください (--allow-outside)</translation>
    </message>
    <message>
        <source>, which is no regular file</source>
        <translation>、通常のファイルではありません</translation>
    </message>
    <message>
        <source>six numbers, one a line</source>
        <translation>六つの数、一行に一つ</translation>
    </message>
    <message>
        <source>pixels without size</source>
        <translation>大きさのない画素</translation>
    </message>
    <message>
        <source>the size of a pixel right and down</source>
        <translation>画素の右方向と下方向の大きさ</translation>
    </message>
    <message>
        <source>a pose is given at {} s, but the odometry of the run does not reach there</source>
        <translation>{} s の位置が与えられていますが、実行のオドメトリはその時刻に達していません</translation>
    </message>
    <message>
        <source>give times of the recording</source>
        <translation>記録の中の時刻を指定してください</translation>
    </message>
    <message>
        <source>visual odometry</source>
        <translation>ビジュアルオドメトリ</translation>
    </message>
    <message>
        <source>left image</source>
        <translation>左画像</translation>
    </message>
    <message>
        <source>right image</source>
        <translation>右画像</translation>
    </message>
    <message>
        <source>{} × {} pixels, {} channels of {} bits</source>
        <translation>{0} × {1} 画素、{3} ビットのチャンネルが {2} 個</translation>
    </message>
    <message>
        <source>8 bits, one or three channels, always the same size</source>
        <translation>8 ビット、1 または 3 チャンネル、常に同じ大きさ</translation>
    </message>
    <message>
        <source>frame {}: found {} points in common with frame {}, {} of them moving as one: too few to tell how the robot moved in between</source>
        <translation>フレーム {0}: フレーム {2} と共通の点は {1} 個、そのうち一緒に動くものは {3} 個です。その間のロボットの動きを求めるには少なすぎます</translation>
    </message>
    <message>
        <source>take more frames (a smaller --every), or give an odometry: --odometry FILE.tum</source>
        <translation>フレームを増やす (--every を小さくする) か、オドメトリを指定してください: --odometry FILE.tum</translation>
    </message>
    <message>
        <source>no view</source>
        <translation>画像も点もありません</translation>
    </message>
    <message>
        <source>no stereo camera</source>
        <translation>ステレオカメラがありません</translation>
    </message>
    <message>
        <source>images for visual odometry</source>
        <translation>ビジュアルオドメトリのための画像</translation>
    </message>
    <message>
        <source>local map</source>
        <translation>局所地図</translation>
    </message>
    <message>
        <source>cell and range</source>
        <translation>セルと範囲</translation>
    </message>
    <message>
        <source>{} m and {} m</source>
        <translation>{} m と {} m</translation>
    </message>
    <message>
        <source>a square of 1 to {} cells a side</source>
        <translation>一辺が 1 から {} セルの正方形</translation>
    </message>
    <message>
        <source>a positive number</source>
        <translation>正の数</translation>
    </message>
    <message>
        <source>observation</source>
        <translation>観測</translation>
    </message>
    <message>
        <source>images</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>no camera calibration</source>
        <translation>カメラの校正がありません</translation>
    </message>
    <message>
        <source>one</source>
        <translation>一つ</translation>
    </message>
    <message>
        <source>view</source>
        <translation>見えたもの</translation>
    </message>
    <message>
        <source>neither images nor points</source>
        <translation>画像も点もありません</translation>
    </message>
    <message>
        <source>one of them</source>
        <translation>どちらか</translation>
    </message>
    <message>
        <source>stereo</source>
        <translation>ステレオ</translation>
    </message>
    <message>
        <source>focal length fx</source>
        <translation>焦点距離 fx</translation>
    </message>
    <message>
        <source>focal length fy</source>
        <translation>焦点距離 fy</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>基線長</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>finite numbers</source>
        <translation>有限の数</translation>
    </message>
    <message>
        <source>camera mount</source>
        <translation>カメラの取り付け</translation>
    </message>
    <message>
        <source>{}° of pitch</source>
        <translation>ピッチ {}°</translation>
    </message>
    <message>
        <source>less than 60°</source>
        <translation>60° 未満</translation>
    </message>
    <message>
        <source>a number from 0 to 1</source>
        <translation>0 から 1 までの数</translation>
    </message>
    <message>
        <source>a multiple of 16, at most 512</source>
        <translation>512 以下の 16 の倍数</translation>
    </message>
    <message>
        <source>an odd number, at most 31</source>
        <translation>31 以下の奇数</translation>
    </message>
    <message>
        <source>no image</source>
        <translation>画像ではありません</translation>
    </message>
    <message>
        <source>{}×{}, {} channels, {} bits</source>
        <translation>{}×{}、{} チャンネル、{} ビット</translation>
    </message>
    <message>
        <source>8 bits, one or three channels</source>
        <translation>8 ビット、1 または 3 チャンネル</translation>
    </message>
    <message>
        <source>the size of the left image: {}</source>
        <translation>左画像と同じ大きさ: {}</translation>
    </message>
    <message>
        <source>at least {} pixels a side at the reduced size</source>
        <translation>縮小した大きさで一辺 {} 画素以上</translation>
    </message>
    <message>
        <source>no projection matrix of a rectified camera</source>
        <translation>平行化したカメラの射影行列ではありません</translation>
    </message>
    <message>
        <source>this matrix twice</source>
        <translation>この行列が二度</translation>
    </message>
    <message>
        <source>it once</source>
        <translation>一度だけ</translation>
    </message>
    <message>
        <source>no line {}:</source>
        <translation>{}: の行がありません</translation>
    </message>
    <message>
        <source>the 12 numbers of the camera</source>
        <translation>カメラの 12 個の数</translation>
    </message>
    <message>
        <source>{} left and {} right</source>
        <translation>左 {}、右 {}</translation>
    </message>
    <message>
        <source>the same for both cameras of a rectified pair</source>
        <translation>平行化した二つのカメラで同じ値</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} と {}</translation>
    </message>
    <message>
        <source>a baseline of {:.4g} m</source>
        <translation>基線長 {:.4g} m</translation>
    </message>
    <message>
        <source>one &gt; 0 and at most {:g} m: the right camera to the right of the left one</source>
        <translation>0 より大きく {:g} m 以下: 右カメラは左カメラの右側</translation>
    </message>
    <message>
        <source>this column twice</source>
        <translation>この列が二度</translation>
    </message>
    <message>
        <source>no column {}</source>
        <translation>列 {} がありません</translation>
    </message>
    <message>
        <source>a header with {}</source>
        <translation>{} を含む見出し行</translation>
    </message>
    <message>
        <source>{} fields</source>
        <translation>{} 個の項目</translation>
    </message>
    <message>
        <source>one image of a pair</source>
        <translation>組の片方の画像だけ</translation>
    </message>
    <message>
        <source>both or none</source>
        <translation>両方、またはどちらもなし</translation>
    </message>
    <message>
        <source>some</source>
        <translation>どちらか</translation>
    </message>
    <message>
        <source>a whole number from 0 to {}</source>
        <translation>0 から {} までの整数</translation>
    </message>
    <message>
        <source>a finite number, at most {}</source>
        <translation>{} 以下の有限の数</translation>
    </message>
    <message>
        <source>a path inside the folder</source>
        <translation>フォルダーの中のパス</translation>
    </message>
    <message>
        <source>stop {} in one more row</source>
        <translation>停止 {} の行がさらに一つ</translation>
    </message>
    <message>
        <source>stop {} a second time</source>
        <translation>停止 {} が二度目</translation>
    </message>
    <message>
        <source>the rows of one stop together</source>
        <translation>一つの停止の行は続けて</translation>
    </message>
    <message>
        <source>{} after {}</source>
        <translation>{1} の後に {0}</translation>
    </message>
    <message>
        <source>times that increase</source>
        <translation>増えていく時刻</translation>
    </message>
    <message>
        <source>frame numbers that increase</source>
        <translation>増えていくフレーム番号</translation>
    </message>
    <message>
        <source>no rows</source>
        <translation>行がありません</translation>
    </message>
    <message>
        <source>a header line and rows</source>
        <translation>見出し行とデータの行</translation>
    </message>
    <message>
        <source>one more row</source>
        <translation>さらに一行</translation>
    </message>
    <message>
        <source>hardly a pixel</source>
        <translation>画素がほとんどありません</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>写真</translation>
    </message>
    <message>
        <source>{:.0f} % of the pixels saturated</source>
        <translation>画素の {:.0f} % が白飛び</translation>
    </message>
    <message>
        <source>at most {:.0f} %: overexposed</source>
        <translation>{:.0f} % 以下。露出が明るすぎます</translation>
    </message>
    <message>
        <source>{:.0f} % of the pixels black</source>
        <translation>画素の {:.0f} % が黒つぶれ</translation>
    </message>
    <message>
        <source>at most {:.0f} %: dark, or the camera is covered</source>
        <translation>{:.0f} % 以下。暗いか、カメラが覆われています</translation>
    </message>
    <message>
        <source>no contrast</source>
        <translation>明暗の差がありません</translation>
    </message>
    <message>
        <source>a picture: the camera looks covered</source>
        <translation>写真。カメラが覆われているようです</translation>
    </message>
    <message>
        <source>{} of {:.0f} matches farther right than in the left image</source>
        <translation>対応点 {1:.0f} 個のうち {0} 個が左画像より右側</translation>
    </message>
    <message>
        <source>them farther left: left and right look swapped</source>
        <translation>左画像より左側。左右が入れ替わっているようです</translation>
    </message>
    <message>
        <source>an empty file</source>
        <translation>空のファイル</translation>
    </message>
    <message>
        <source>a PNG or JPEG image</source>
        <translation>PNG または JPEG の画像</translation>
    </message>
    <message>
        <source>at most {} megapixels</source>
        <translation>{} メガピクセル以下</translation>
    </message>
    <message>
        <source>an image that is cut off</source>
        <translation>途中で切れた画像</translation>
    </message>
    <message>
        <source>a whole one</source>
        <translation>完全な画像</translation>
    </message>
    <message>
        <source>more than 256 MiB</source>
        <translation>256 MiB 超</translation>
    </message>
    <message>
        <source>a smaller image</source>
        <translation>より小さい画像</translation>
    </message>
    <message>
        <source>an image that can be decoded</source>
        <translation>復号できる画像</translation>
    </message>
    <message>
        <source>a damaged image</source>
        <translation>壊れた画像</translation>
    </message>
    <message>
        <source>one that can be decoded</source>
        <translation>復号できる画像</translation>
    </message>
    <message>
        <source>{}: cannot be encoded as PNG</source>
        <translation>{}: PNG として符号化できません</translation>
    </message>
    <message>
        <source>no rotation matrix</source>
        <translation>回転行列ではありません</translation>
    </message>
    <message>
        <source>an orthonormal one</source>
        <translation>正規直交行列</translation>
    </message>
    <message>
        <source>000000.png or .jpg and so on</source>
        <translation>000000.png または .jpg など</translation>
    </message>
    <message>
        <source>a time in seconds</source>
        <translation>秒単位の時刻</translation>
    </message>
    <message>
        <source>time {} after {}</source>
        <translation>時刻 {1} の後に {0}</translation>
    </message>
    <message>
        <source>one more time</source>
        <translation>さらに一つの時刻</translation>
    </message>
    <message>
        <source>no time</source>
        <translation>時刻がありません</translation>
    </message>
    <message>
        <source>one a line</source>
        <translation>一行に一つ</translation>
    </message>
    <message>
        <source>{} poses</source>
        <translation>位置 {} 個</translation>
    </message>
    <message>
        <source>{}, one for each line of times.txt</source>
        <translation>{} 個、times.txt の一行に一つ</translation>
    </message>
    <message>
        <source>a YAML or XML file of OpenCV with M1 D1 M2 D2 R T</source>
        <translation>M1 D1 M2 D2 R T を含む OpenCV の YAML または XML ファイル</translation>
    </message>
    <message>
        <source>too many values</source>
        <translation>多すぎる値</translation>
    </message>
    <message>
        <source>no calibration of OpenCV</source>
        <translation>OpenCV の校正ではありません</translation>
    </message>
    <message>
        <source>{} points with w outside 0 … 1</source>
        <translation>w が 0 … 1 の外にある点 {} 個</translation>
    </message>
    <message>
        <source>update the program to open this recording</source>
        <translation>この記録を開くにはプログラムを更新してください</translation>
    </message>
    <message>
        <source>that of rectified images, as KITTI writes it (&quot;rectified&quot; is true)</source>
        <translation>KITTI 形式の、平行化した画像の校正 (&quot;rectified&quot; は true)</translation>
    </message>
    <message>
        <source>a .yml, .yaml or .xml of OpenCV (&quot;rectified&quot; is false)</source>
        <translation>OpenCV の .yml、.yaml または .xml (&quot;rectified&quot; は false)</translation>
    </message>
    <message>
        <source>the folder of a recording</source>
        <translation>記録のフォルダー</translation>
    </message>
    <message>
        <source>neither recording.json nor a KITTI sequence</source>
        <translation>recording.json も KITTI のシーケンスもありません</translation>
    </message>
    <message>
        <source>recording.json, or times.txt and image_0 or image_2</source>
        <translation>recording.json、または times.txt と image_0 か image_2</translation>
    </message>
    <message>
        <source>{}: found a folder that is not empty, expected a new one</source>
        <translation>{}: 空でないフォルダー (必要: 新しいフォルダー)</translation>
    </message>
    <message>
        <source>{}: cannot be created: {}</source>
        <translation>{}: 作成できません: {}</translation>
    </message>
    <message>
        <source>{}: found frame {} at {} s after frame {} at {} s, expected both to increase</source>
        <translation>{0}: フレーム {3} ({4} s) の後にフレーム {1} ({2} s) (必要: どちらも増加)</translation>
    </message>
    <message>
        <source>rectified images scaled by {:.3g}</source>
        <translation>平行化で {:.3g} 倍になる画像</translation>
    </message>
    <message>
        <source>a calibration that leaves both images about as they are: is it that of these cameras?</source>
        <translation>画像をほぼ元のまま保つ校正。このカメラのものですか?</translation>
    </message>
    <message>
        <source>{}: frame {} is at {} s, but the odometry starts late, at {} s</source>
        <translation>{}: フレーム {} は {} s ですが、オドメトリは {} s から始まります</translation>
    </message>
    <message>
        <source>the odometry belongs to another time</source>
        <translation>オドメトリは別の時刻のものです</translation>
    </message>
    <message>
        <source>begin later: --from {}</source>
        <translation>もっと後から始めてください: --from {}</translation>
    </message>
    <message>
        <source>{}: frame {} is at {} s, but the odometry ends at {} s</source>
        <translation>{}: フレーム {} は {} s ですが、オドメトリは {} s で終わります</translation>
    </message>
    <message>
        <source>end earlier: --to {}</source>
        <translation>もっと前で終えてください: --to {}</translation>
    </message>
    <message>
        <source>--every: found {}, expected 1 or more</source>
        <translation>--every: {} (必要: 1 以上)</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>no frame with {} from {} to {}</source>
        <translation>{1} から {2} までに{0}のあるフレームがありません</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>最後</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>一つ以上</translation>
    </message>
    <message>
        <source>images but no camera</source>
        <translation>画像はあるがカメラの校正がありません</translation>
    </message>
    <message>
        <source>the calibration of the camera</source>
        <translation>カメラの校正</translation>
    </message>
    <message>
        <source>points chosen to see with</source>
        <translation>見るために点が選ばれています</translation>
    </message>
    <message>
        <source>{}: found no odometry, expected odometry.tum</source>
        <translation>{}: オドメトリがありません (必要: odometry.tum)</translation>
    </message>
    <message>
        <source>give one: --odometry FILE.tum</source>
        <translation>指定してください: --odometry FILE.tum</translation>
    </message>
    <message>
        <source>a matrix</source>
        <translation>行列</translation>
    </message>
    <message>
        <source> or </source>
        <translation> または </translation>
    </message>
    <message>
        <source>a value that is no number</source>
        <translation>数でない値</translation>
    </message>
    <message>
        <source>the size of the images, 1 to {} pixels</source>
        <translation>画像の大きさ、1 から {} 画素</translation>
    </message>
    <message>
        <source>a focal length of {:g} px</source>
        <translation>焦点距離 {:g} px</translation>
    </message>
    <message>
        <source>one from {:g} to {:g} px for images {} px wide</source>
        <translation>幅 {2} px の画像では {0:g} から {1:g} px</translation>
    </message>
    <message>
        <source>a principal point at {:g}, {:g}</source>
        <translation>{:g}, {:g} にある主点</translation>
    </message>
    <message>
        <source>one inside the images of {} × {} pixels</source>
        <translation>{} × {} 画素の画像の内側</translation>
    </message>
    <message>
        <source>no camera matrix</source>
        <translation>カメラ行列ではありません</translation>
    </message>
    <message>
        <source>cameras turned by {:.0f}°</source>
        <translation>{:.0f}° 回ったカメラ</translation>
    </message>
    <message>
        <source>at most {:.0f}°: both look the same way</source>
        <translation>{:.0f}° 以下。両方とも同じ方向を向きます</translation>
    </message>
    <message>
        <source>cameras {:.4g} apart</source>
        <translation>間隔が {:.4g} のカメラ</translation>
    </message>
    <message>
        <source>{:g} to {:g} metres (T in metres: was the square of the board given in metres?)</source>
        <translation>{:g} から {:g} メートル (T はメートル単位: 板のマス目の大きさをメートルで入力しましたか?)</translation>
    </message>
    <message>
        <source>cameras side by side</source>
        <translation>横に並んだカメラ</translation>
    </message>
    <message>
        <source>the right camera {:.4g} m left of the left one</source>
        <translation>右カメラが左カメラの {:.4g} m 左</translation>
    </message>
    <message>
        <source>it on the right: left and right look swapped</source>
        <translation>右側。左右が入れ替わっているようです</translation>
    </message>
    <message>
        <source>8: time x y z qx qy qz qw</source>
        <translation>8 個: time x y z qx qy qz qw</translation>
    </message>
    <message>
        <source>a quaternion of length {:.3g}</source>
        <translation>長さ {:.3g} の四元数</translation>
    </message>
    <message>
        <source>length 1</source>
        <translation>長さ 1</translation>
    </message>
    <message>
        <source>pose {}</source>
        <translation>位置 {}</translation>
    </message>
    <message>
        <source>one more pose</source>
        <translation>さらに一つの位置</translation>
    </message>
    <message>
        <source>no pose</source>
        <translation>位置がありません</translation>
    </message>
    <message>
        <source>lines of time x y z qx qy qz qw</source>
        <translation>time x y z qx qy qz qw の行</translation>
    </message>
    <message>
        <source>the right image taken at {} s, the left one at {} s</source>
        <translation>右画像の撮影は {} s、左画像は {} s</translation>
    </message>
    <message>
        <source>both within {:g} s</source>
        <translation>二つの差が {:g} s 以内</translation>
    </message>
    <message>
        <source>images that the calibration belongs to: its principal point is at x = {:g} px</source>
        <translation>校正に対応する画像。主点は x = {:g} px にあります</translation>
    </message>
    <message>
        <source>{} × {} as {}</source>
        <translation>{2} {0} × {1}</translation>
    </message>
    <message>
        <source>the calibration says</source>
        <translation>校正のとおり</translation>
    </message>
    <message>
        <source>the images before: one camera</source>
        <translation>これまでの画像と同じ (カメラは一つ)</translation>
    </message>
    <message>
        <source>rendering</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} から {}</translation>
    </message>
    <message>
        <source>width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>視野角</translation>
    </message>
    <message>
        <source>camera x</source>
        <translation>カメラの x</translation>
    </message>
    <message>
        <source>camera y</source>
        <translation>カメラの y</translation>
    </message>
    <message>
        <source>camera height</source>
        <translation>カメラの高さ</translation>
    </message>
    <message>
        <source>camera pitch</source>
        <translation>カメラのピッチ</translation>
    </message>
    <message>
        <source>camera yaw</source>
        <translation>カメラのヨー</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>雑音</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>露出</translation>
    </message>
    <message>
        <source>azimuth of the sun</source>
        <translation>太陽の方位角</translation>
    </message>
    <message>
        <source>elevation of the sun</source>
        <translation>太陽の高度</translation>
    </message>
    <message>
        <source>strength of the sun</source>
        <translation>太陽の強さ</translation>
    </message>
    <message>
        <source>share of the clouds</source>
        <translation>雲の割合</translation>
    </message>
    <message>
        <source>period of the clouds</source>
        <translation>雲の周期</translation>
    </message>
    <message>
        <source>{}: the folder cannot be made</source>
        <translation>{}: フォルダーを作成できません</translation>
    </message>
    <message>
        <source>{}, {}, {} or {}</source>
        <translation>{}、{}、{} または {}</translation>
    </message>
    <message>
        <source>at least 3 vertices</source>
        <translation>3 個以上の頂点</translation>
    </message>
    <message>
        <source>an outline that does not meet itself</source>
        <translation>自分自身と接しない輪郭</translation>
    </message>
    <message>
        <source>none of {} could be used{}</source>
        <translation>{}のどれも使えませんでした{}</translation>
    </message>
    <message>
        <source>{} observations</source>
        <translation>{} 件の観測</translation>
    </message>
    <message>
        <source>what came</source>
        <translation>届いたもの</translation>
    </message>
    <message>
        <source>; the first: {}</source>
        <translation>。最初のもの: {}</translation>
    </message>
    <message>
        <source>Is the start where the recording begins, and does it look the right way?</source>
        <translation>出発位置は記録の始まりの場所にあり、正しい方向を向いていますか?</translation>
    </message>
    <message>
        <source>Nothing in the images was taken for the wall of a building.</source>
        <translation>画像の中に建物の壁とみなせるものがありませんでした。</translation>
    </message>
    <message>
        <source>Look at the crosses on the camera images; teach your own buildings where they are missing, or take every wall for one (--model none).</source>
        <translation>カメラ画像の上の十字を見てください。足りない場所では建物を教えるか、すべての壁を建物とみなしてください (--model none)。</translation>
    </message>
    <message>
        <source>Nothing came back from within {:.0f} m.</source>
        <translation>{:.0f} m 以内から何も返ってきませんでした。</translation>
    </message>
    <message>
        <source>Are the points in metres, x forward and y left, and range_limit_m that of the sensor?</source>
        <translation>点はメートル単位で x が前、y が左ですか? range_limit_m はセンサーの値ですか?</translation>
    </message>
    <message>
        <source>None of {} returns was taken for a wall: points of several heights count where some stand above one another, and these are too sparse for that.</source>
        <translation>返ってきた {} 点のどれも壁とみなされませんでした。高さの異なる点は上下に重なっている場所で壁とみなされますが、これらの点はまばらすぎます。</translation>
    </message>
    <message>
        <source>Give denser clouds, or one height for all points (z = 0): then each counts as it is.</source>
        <translation>もっと密な点群を使うか、すべての点の高さを同じ (z = 0) にしてください。そうすると各点がそのまま使われます。</translation>
    </message>
    <message>
        <source>Walls were seen in {} directions, up to {:.0f} m away</source>
        <translation>壁は {} 方向に、最大 {:.0f} m 先まで見えました</translation>
    </message>
    <message>
        <source>{}, but the way comes no nearer than {:.0f} m to a drawn building, and the sensor sees {:.0f} m.</source>
        <translation>{}が、軌跡は描いた建物から {:.0f} m より近くを通らず、センサーに見えるのは {:.0f} m までです。</translation>
    </message>
    <message>
        <source>{}, but none is long and straight enough, or near enough to where a building is drawn.</source>
        <translation>{}が、十分に長くまっすぐなもの、または建物を描いた場所に十分近いものがありません。</translation>
    </message>
    <message>
        <source>Check where the start is and which way it looks; leave the scale and the turn of the drawing free; draw what stands along the way.</source>
        <translation>出発位置とその向きを確かめてください。図面の縮尺と向きを自由にし、道沿いにあるものを描いてください。</translation>
    </message>
    <message>
        <source>Nothing was corrected: buildings were in sight in {} of {} observations, but none of them was taken for a drawn one.</source>
        <translation>何も補正されませんでした。観測 {1} 件のうち {0} 件で建物が見えましたが、描いた建物とみなせるものはありませんでした。</translation>
    </message>
    <message>
        <source>All buildings of the drawing are fixed.</source>
        <translation>図面の建物はすべて固定されています。</translation>
    </message>
    <message>
        <source> The way comes no nearer than {:.0f} m to one.</source>
        <translation>軌跡は描いた建物から {:.0f} m より近くを通りません。</translation>
    </message>
    <message>
        <source> Leave the scale and the turn of the drawing free.</source>
        <translation>図面の縮尺と向きを自由にしてください。</translation>
    </message>
    <message>
        <source>No building was recognised in {} observations: the drawing is as it was, and the way is that of the motion alone. {}</source>
        <translation>観測 {} 件で建物が一つも認識されませんでした。図面は元のままで、軌跡は動きだけによるものです。{}</translation>
    </message>
    <message>
        <source>No building was in sight in {} of {} observations: there the way is that of the motion alone.</source>
        <translation>観測 {1} 件のうち {0} 件で建物が見えませんでした。その間の軌跡は動きだけによるものです。</translation>
    </message>
    <message>
        <source>Draw more of what stands along the way.</source>
        <translation>道沿いにあるものをもっと描いてください。</translation>
    </message>
    <message>
        <source>the beginning of the run is no longer kept</source>
        <translation>実行の始まりはもう残っていません</translation>
    </message>
    <message>
        <source>run its recording with the changed drawing</source>
        <translation>変更した図面でその記録を実行してください</translation>
    </message>
    <message>
        <source>route</source>
        <translation>経路</translation>
    </message>
    <message>
        <source>no way to drive</source>
        <translation>走る道がありません</translation>
    </message>
    <message>
        <source>a route or a start</source>
        <translation>経路または出発位置</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>step</source>
        <translation>一歩</translation>
    </message>
    <message>
        <source>a positive one, less than {:g} on the route</source>
        <translation>正の値、経路全体で {:g} 未満</translation>
    </message>
    <message>
        <source>building {} in the way after {:.0f} m</source>
        <translation>{1:.0f} m 先に建物 {0} があり、通れません</translation>
    </message>
    <message>
        <source>a way around the buildings</source>
        <translation>建物を避ける道</translation>
    </message>
    <message>
        <source>route: found no way to drive, expected a route or a start</source>
        <translation>経路: 走る道がありません (必要: 経路または出発位置)</translation>
    </message>
    <message>
        <source>draw a route, or a start that looks along a free way</source>
        <translation>経路を描くか、空いた道の方を向く出発位置を描いてください</translation>
    </message>
    <message>
        <source>at most {:.0f} m</source>
        <translation>{:.0f} m 以下</translation>
    </message>
    <message>
        <source>images chosen to see with</source>
        <translation>見るために画像が選ばれています</translation>
    </message>
    <message>
        <source>range points for odometry from scans: --source points</source>
        <translation>スキャンによるオドメトリのための距離の点: --source points</translation>
    </message>
    <message>
        <source>frame {}</source>
        <translation>フレーム {}</translation>
    </message>
    <message>
        <source>range points for odometry from scans</source>
        <translation>スキャンによるオドメトリのための距離の点</translation>
    </message>
    <message>
        <source>{}: cannot {}: {}</source>
        <translation>{}: {}ができません: {}</translation>
    </message>
    <message>
        <source>{}: found images of the pixel format {:#x}, expected Mono8 or a Bayer one of 8 bit</source>
        <translation>{}: 画素形式 {:#x} の画像 (必要: Mono8 または 8 ビットの Bayer)</translation>
    </message>
    <message>
        <source>open it</source>
        <translation>開くこと</translation>
    </message>
    <message>
        <source>{}: no such camera</source>
        <translation>{}: カメラがありません</translation>
    </message>
    <message>
        <source>receive its images</source>
        <translation>画像の受信</translation>
    </message>
    <message>
        <source>ask how large its images are</source>
        <translation>画像の大きさの問い合わせ</translation>
    </message>
    <message>
        <source>start it</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>make it send on and on</source>
        <translation>連続送信の設定</translation>
    </message>
    <message>
        <source>set the size of its images</source>
        <translation>画像の大きさの設定</translation>
    </message>
    <message>
        <source>set its rate</source>
        <translation>フレームレートの設定</translation>
    </message>
    <message>
        <source>{}: found {} bytes, expected {} × {} pixels</source>
        <translation>{}: {} バイト (必要: {} × {} 画素)</translation>
    </message>
    <message>
        <source>image of another size</source>
        <translation>大きさの違う画像</translation>
    </message>
    <message>
        <source>half image</source>
        <translation>途中までの画像</translation>
    </message>
    <message>
        <source>repeated image</source>
        <translation>繰り返しの画像</translation>
    </message>
    <message>
        <source>{}: the video is at its end</source>
        <translation>{}: 動画が終わりました</translation>
    </message>
    <message>
        <source>{}: no more images come</source>
        <translation>{}: 画像が届かなくなりました</translation>
    </message>
    <message>
        <source>FireWire camera: cannot {}: {}</source>
        <translation>FireWire カメラ: {}ができません: {}</translation>
    </message>
    <message>
        <source>there is no FireWire here</source>
        <translation>このコンピューターには FireWire がありません</translation>
    </message>
    <message>
        <source>list cameras</source>
        <translation>カメラの一覧の取得</translation>
    </message>
    <message>
        <source>FireWire camera: cannot open it</source>
        <translation>FireWire カメラ: 開けません</translation>
    </message>
    <message>
        <source>set its speed</source>
        <translation>速度の設定</translation>
    </message>
    <message>
        <source>make it send its images together</source>
        <translation>二つの画像の同時送信の設定</translation>
    </message>
    <message>
        <source>ask its size</source>
        <translation>大きさの問い合わせ</translation>
    </message>
    <message>
        <source>set its image</source>
        <translation>画像の設定</translation>
    </message>
    <message>
        <source>take an image</source>
        <translation>画像の取得</translation>
    </message>
    <message>
        <source>give an image back</source>
        <translation>画像の返却</translation>
    </message>
    <message>
        <source>ask what it sends</source>
        <translation>送信形式の問い合わせ</translation>
    </message>
    <message>
        <source>FireWire camera: it is no stereo head</source>
        <translation>FireWire カメラ: ステレオヘッドではありません</translation>
    </message>
    <message>
        <source>no FireWire camera answers: is it connected, and may you use /dev/fw*?</source>
        <translation>FireWire カメラが応答しません。接続されていて、/dev/fw* を使う権限がありますか?</translation>
    </message>
    <message>
        <source>FireWire camera: found &quot;{}&quot;, expected its number (hexadecimal) or &quot;first&quot;</source>
        <translation>FireWire カメラ: 「{}」(必要: カメラの番号 (16 進) または &quot;first&quot;)</translation>
    </message>
    <message>
        <source>the FireWire camera {} does not answer; {:016x} does</source>
        <translation>FireWire カメラ {} が応答しません。{:016x} は応答しています</translation>
    </message>
    <message>
        <source>FireWire camera: found {} bytes a pixel, expected the 2 or 3 of a stereo head</source>
        <translation>FireWire カメラ: 一画素 {} バイト (必要: ステレオヘッドの 2 または 3)</translation>
    </message>
    <message>
        <source>this program was built without {}, which such cameras need</source>
        <translation>このプログラムは {} なしで作られていますが、このカメラにはそれが必要です</translation>
    </message>
    <message>
        <source>{}: cannot be opened: is it there, and in use by nobody else?</source>
        <translation>{}: 開けません。接続されていて、ほかで使われていませんか?</translation>
    </message>
    <message>
        <source>{}: found images of {} channels and {} bits, expected 1 or 3 of 8</source>
        <translation>{}: {} チャンネル、{} ビットの画像 (必要: 8 ビットで 1 または 3 チャンネル)</translation>
    </message>
    <message>
        <source>found images of {} × {} pixels, expected {} × {}</source>
        <translation>{} × {} 画素の画像 (必要: {} × {})</translation>
    </message>
    <message>
        <source>the image is frozen</source>
        <translation>画像が止まっています</translation>
    </message>
    <message>
        <source>image of an odd width</source>
        <translation>幅が奇数の画像</translation>
    </message>
    <message>
        <source>found images {} pixels wide, expected an even width: two images side by side</source>
        <translation>幅 {} 画素の画像 (必要: 偶数の幅。二つの画像が左右に並びます)</translation>
    </message>
    <message>
        <source>image without its pair</source>
        <translation>組の相手のない画像</translation>
    </message>
    <message>
        <source>left and right images never come together; right_delay_ms = {:.0f} would fit, if it is always the same</source>
        <translation>左右の画像が同時に届きません。ずれが一定なら right_delay_ms = {:.0f} が合います</translation>
    </message>
    <message>
        <source>pair of images of two sizes</source>
        <translation>大きさの違う画像の組</translation>
    </message>
    <message>
        <source>left and right images are of two sizes</source>
        <translation>左右の画像の大きさが違います</translation>
    </message>
    <message>
        <source>the clock of the base was set anew</source>
        <translation>台車の時計が合わせ直されました</translation>
    </message>
    <message>
        <source>the base began its odometry anew; what it did in between is not known</source>
        <translation>台車がオドメトリを最初から始めました。その間の動きはわかりません</translation>
    </message>
    <message>
        <source>the base tells leaps that no robot can do</source>
        <translation>台車の伝える動きがロボットにはありえない飛び方をしています</translation>
    </message>
    <message>
        <source>Foxglove: port {} cannot be opened: {}</source>
        <translation>Foxglove: ポート {} を開けません: {}</translation>
    </message>
    <message>
        <source>another program may have it: choose another port</source>
        <translation>ほかのプログラムが使っているかもしれません。別のポートを選んでください</translation>
    </message>
    <message>
        <source>subscribe or unsubscribe</source>
        <translation>subscribe または unsubscribe</translation>
    </message>
    <message>
        <source>one that was advertised</source>
        <translation>公開されているもの</translation>
    </message>
    <message>
        <source>too many subscriptions</source>
        <translation>多すぎる購読</translation>
    </message>
    <message>
        <source>{} stamped in the future</source>
        <translation>未来の時刻が付いた{}</translation>
    </message>
    <message>
        <source>{} late</source>
        <translation>遅れて届いた{}</translation>
    </message>
    <message>
        <source>{} repeated or out of order</source>
        <translation>繰り返しまたは順序の乱れた{}</translation>
    </message>
    <message>
        <source>odometry that is not finite</source>
        <translation>有限でないオドメトリ</translation>
    </message>
    <message>
        <source>odometry</source>
        <translation>オドメトリ</translation>
    </message>
    <message>
        <source>scan with too many points</source>
        <translation>点が多すぎるスキャン</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>scan without a single return</source>
        <translation>一点も返ってこないスキャン</translation>
    </message>
    <message>
        <source>pair of images</source>
        <translation>画像の組</translation>
    </message>
    <message>
        <source>no odometry at the time of an observation</source>
        <translation>観測の時刻にオドメトリなし</translation>
    </message>
    <message>
        <source>observation out of order</source>
        <translation>順序の乱れた観測</translation>
    </message>
    <message>
        <source>look around: {}</source>
        <translation>見回し: {}</translation>
    </message>
    <message>
        <source>image that nothing can be seen with</source>
        <translation>何も見えない画像</translation>
    </message>
    <message>
        <source>live frame {}</source>
        <translation>実機のフレーム {}</translation>
    </message>
    <message>
        <source>{} × {} as the calibration says</source>
        <translation>校正のとおり {} × {}</translation>
    </message>
    <message>
        <source>{}, left</source>
        <translation>{}、左</translation>
    </message>
    <message>
        <source>{}, right</source>
        <translation>{}、右</translation>
    </message>
    <message>
        <source>unexpected error</source>
        <translation>予期しないエラー</translation>
    </message>
    <message>
        <source>silent for {:.1f} s</source>
        <translation>{:.1f} s の間応答なし</translation>
    </message>
    <message>
        <source>the robot drove on while it looked around</source>
        <translation>見回している間にロボットが動きました</translation>
    </message>
    <message>
        <source>the head was lost while it looked around</source>
        <translation>見回している間に雲台との接続が切れました</translation>
    </message>
    <message>
        <source>the head did not arrive</source>
        <translation>雲台が目標に達しませんでした</translation>
    </message>
    <message>
        <source>no pair of images came while the head stood</source>
        <translation>雲台が止まっている間に画像の組が届きませんでした</translation>
    </message>
    <message>
        <source>opening the port of the odometry</source>
        <translation>オドメトリのポートを開いています</translation>
    </message>
    <message>
        <source>waiting for the first odometry</source>
        <translation>最初のオドメトリを待っています</translation>
    </message>
    <message>
        <source>nothing that is odometry has come for {} s</source>
        <translation>{} s の間オドメトリとして読めるものが届いていません</translation>
    </message>
    <message>
        <source>no odometry has come for {} s</source>
        <translation>{} s の間オドメトリが届いていません</translation>
    </message>
    <message>
        <source>odometry line</source>
        <translation>オドメトリの行</translation>
    </message>
    <message>
        <source>a number within ±{:g}</source>
        <translation>±{:g} 以内の数</translation>
    </message>
    <message>
        <source>checksum {}</source>
        <translation>チェックサム {}</translation>
    </message>
    <message>
        <source>{} or JSON</source>
        <translation>{} または JSON</translation>
    </message>
    <message>
        <source>nobody looks</source>
        <translation>誰も見ていません</translation>
    </message>
    <message>
        <source>one looks</source>
        <translation>1 人が見ています</translation>
    </message>
    <message>
        <source>{} look</source>
        <translation>{} 人が見ています</translation>
    </message>
    <message>
        <source>{} on at port {}</source>
        <translation>{} (ポート {})</translation>
    </message>
    <message>
        <source>found {} arc-seconds a position, expected 1 to 64800</source>
        <translation>一目盛り {} 秒角 (必要: 1 から 64800)</translation>
    </message>
    <message>
        <source>found limits {} to {} positions, expected a range within a turn</source>
        <translation>可動範囲 {} から {} 目盛り (必要: 一回転以内の範囲)</translation>
    </message>
    <message>
        <source>found speeds {} to {} positions/s, expected a range above 0</source>
        <translation>速度 {} から {} 目盛り/s (必要: 0 より大きい範囲)</translation>
    </message>
    <message>
        <source>opening the port of the head</source>
        <translation>雲台のポートを開いています</translation>
    </message>
    <message>
        <source>asking the head what it can do</source>
        <translation>雲台の性能を問い合わせています</translation>
    </message>
    <message>
        <source>; it finds its way back at its stops</source>
        <translation>。端に当てて位置を求め直します</translation>
    </message>
    <message>
        <source>, twice on the same way; it stands until it is asked to look elsewhere</source>
        <translation>。同じ動きで二度目です。別の方向を指示されるまで止まっています</translation>
    </message>
    <message>
        <source>the head stands at {:.1f}°, {:.1f}° and was sent to {:.1f}°, {:.1f}°</source>
        <translation>雲台は {:.1f}°、{:.1f}° にありますが、目標は {:.1f}°、{:.1f}° でした</translation>
    </message>
    <message>
        <source>the head ran against its {} limit</source>
        <translation>雲台が{}の限界に当たりました</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>パン</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>チルト</translation>
    </message>
    <message>
        <source>the head refuses: {}</source>
        <translation>雲台が拒否しました: {}</translation>
    </message>
    <message>
        <source>the head never answers twice the same</source>
        <translation>雲台の応答が毎回違います</translation>
    </message>
    <message>
        <source>the head does not answer to {}</source>
        <translation>雲台が {} に応答しません</translation>
    </message>
    <message>
        <source>passed over: {:.2f} s late, the budget is {:.2f} s</source>
        <translation>省略しました: {:.2f} s の遅れ、許容は {:.2f} s</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>次のいずれか: {}</translation>
    </message>
    <message>
        <source>an unknown key</source>
        <translation>未知のキー</translation>
    </message>
    <message>
        <source>some text</source>
        <translation>何かの文字</translation>
    </message>
    <message>
        <source>a path</source>
        <translation>パス</translation>
    </message>
    <message>
        <source>it beside &quot;ros&quot;</source>
        <translation>&quot;ros&quot; との併用</translation>
    </message>
    <message>
        <source>the topics &quot;left&quot; and &quot;right&quot;</source>
        <translation>トピック &quot;left&quot; と &quot;right&quot;</translation>
    </message>
    <message>
        <source>&quot;device&quot; and &quot;left&quot; or &quot;right&quot;</source>
        <translation>&quot;device&quot; と &quot;left&quot; または &quot;right&quot; の併用</translation>
    </message>
    <message>
        <source>&quot;device&quot; (both images in one) or &quot;left&quot; and &quot;right&quot;</source>
        <translation>&quot;device&quot; (一つに両方の画像)、または &quot;left&quot; と &quot;right&quot;</translation>
    </message>
    <message>
        <source>it beside two cameras</source>
        <translation>二つのカメラとの併用</translation>
    </message>
    <message>
        <source>&quot;device&quot; (both images in one)</source>
        <translation>&quot;device&quot; (一つに両方の画像)</translation>
    </message>
    <message>
        <source>no &quot;device&quot;</source>
        <translation>&quot;device&quot; がありません</translation>
    </message>
    <message>
        <source>one: a stereo head that sends both images in one</source>
        <translation>一つに両方の画像を送るステレオヘッド</translation>
    </message>
    <message>
        <source>at least one pan</source>
        <translation>一つ以上のパン角</translation>
    </message>
    <message>
        <source>a camera and a scanner</source>
        <translation>カメラとスキャナーの両方</translation>
    </message>
    <message>
        <source>neither camera nor scanner</source>
        <translation>カメラもスキャナーもありません</translation>
    </message>
    <message>
        <source>one of them: what the robot sees with</source>
        <translation>ロボットが見るためのどちらか一つ</translation>
    </message>
    <message>
        <source>no camera on it</source>
        <translation>載せるカメラがありません</translation>
    </message>
    <message>
        <source>a camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>no head</source>
        <translation>雲台がありません</translation>
    </message>
    <message>
        <source>a head to look around</source>
        <translation>見回すための雲台</translation>
    </message>
    <message>
        <source>nothing that measures it</source>
        <translation>動きを測るものがありません</translation>
    </message>
    <message>
        <source>lines or ros: a robot that stops to look around sees too little in common between two stops</source>
        <translation>lines または ros。止まって見回すロボットは、二つの停止の間で共通に見えるものが少なすぎます</translation>
    </message>
    <message>
        <source>odometry that is not by ROS</source>
        <translation>ROS によらないオドメトリ</translation>
    </message>
    <message>
        <source>odometry &quot;ros&quot;</source>
        <translation>オドメトリ &quot;ros&quot;</translation>
    </message>
    <message>
        <source>visual without a camera</source>
        <translation>カメラのない visual</translation>
    </message>
    <message>
        <source>scan without a scanner</source>
        <translation>スキャナーのない scan</translation>
    </message>
    <message>
        <source>a scanner</source>
        <translation>スキャナー</translation>
    </message>
    <message>
        <source>update the program to use this rig</source>
        <translation>この構成を使うにはプログラムを更新してください</translation>
    </message>
    <message>
        <source>a virtual rig has no file</source>
        <translation>仮想ロボットにはファイルがありません</translation>
    </message>
    <message>
        <source>message from the network</source>
        <translation>ネットワークからのメッセージ</translation>
    </message>
    <message>
        <source>byte {}</source>
        <translation>{} バイト目</translation>
    </message>
    <message>
        <source>another value</source>
        <translation>別の値</translation>
    </message>
    <message>
        <source>a JSON object</source>
        <translation>JSON オブジェクト</translation>
    </message>
    <message>
        <source>a CBOR map</source>
        <translation>CBOR マップ</translation>
    </message>
    <message>
        <source>{} bytes in pieces</source>
        <translation>断片の合計 {} バイト</translation>
    </message>
    <message>
        <source>the images of one camera find no partner of the same moment</source>
        <translation>片方のカメラの画像に、同時刻の相手が見つかりません</translation>
    </message>
    <message>
        <source>no rotation</source>
        <translation>回転ではありません</translation>
    </message>
    <message>
        <source>a quaternion of length 1</source>
        <translation>長さ 1 の四元数</translation>
    </message>
    <message>
        <source>no field {}</source>
        <translation>フィールド {} がありません</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x、y、z</translation>
    </message>
    <message>
        <source>{} × {} points</source>
        <translation>{} × {} 点</translation>
    </message>
    <message>
        <source>waiting for {}</source>
        <translation>{} を待っています</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>another kind of value</source>
        <translation>別の種類の値</translation>
    </message>
    <message>
        <source>no {}</source>
        <translation>{} がありません</translation>
    </message>
    <message>
        <source>the member {}</source>
        <translation>メンバー {}</translation>
    </message>
    <message>
        <source>{} values</source>
        <translation>{} 個の値</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>a number from {:g} to {:g}</source>
        <translation>{:g} から {:g} までの数</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>a text of {} bytes</source>
        <translation>{} バイトの文字列</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>バイト</translation>
    </message>
    <message>
        <source>a list of numbers</source>
        <translation>数のリスト</translation>
    </message>
    <message>
        <source>numbers alone</source>
        <translation>数のみ</translation>
    </message>
    <message>
        <source>a list of numbers of 8 to 64 bits</source>
        <translation>8 から 64 ビットの数のリスト</translation>
    </message>
    <message>
        <source>nobody answers at {}</source>
        <translation>{} からの応答がありません</translation>
    </message>
    <message>
        <source>a fragment in fragments</source>
        <translation>断片の中の断片</translation>
    </message>
    <message>
        <source>a message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>opening the port of the scanner</source>
        <translation>スキャナーのポートを開いています</translation>
    </message>
    <message>
        <source>asking the scanner what it can do</source>
        <translation>スキャナーの性能を問い合わせています</translation>
    </message>
    <message>
        <source>the scanner cannot switch its laser on: it reports status {}</source>
        <translation>スキャナーがレーザーを点灯できません: ステータス {}</translation>
    </message>
    <message>
        <source>the scanner stopped: it reports status {}</source>
        <translation>スキャナーが停止しました: ステータス {}</translation>
    </message>
    <message>
        <source>the scanner has sent no whole scan for a second</source>
        <translation>スキャナーから 1 秒間、完全なスキャンが届いていません</translation>
    </message>
    <message>
        <source>what is at this port does not answer as a Hokuyo scanner</source>
        <translation>このポートの機器は北陽のスキャナーとして応答しません</translation>
    </message>
    <message>
        <source>asking the scanner what it is</source>
        <translation>スキャナーの機種を問い合わせています</translation>
    </message>
    <message>
        <source>the scanner reports an error and is reset</source>
        <translation>スキャナーがエラーを報告したため、リセットしています</translation>
    </message>
    <message>
        <source>the scanner reports an error</source>
        <translation>スキャナーがエラーを報告しています</translation>
    </message>
    <message>
        <source>the scanner sends no whole turn: does its motor run?</source>
        <translation>スキャナーから一回転分のデータが届きません。モーターは回っていますか?</translation>
    </message>
    <message>
        <source>what is at this port does not answer as an RPLIDAR</source>
        <translation>このポートの機器は RPLIDAR として応答しません</translation>
    </message>
    <message>
        <source>{} is not there: is it plugged in?</source>
        <translation>{} がありません。接続されていますか?</translation>
    </message>
    <message>
        <source>{} may not be opened: another program has it, or you are not in the group dialout</source>
        <translation>{} を開けません。ほかのプログラムが使っているか、あなたがグループ dialout に属していません</translation>
    </message>
    <message>
        <source>{} is gone: {}</source>
        <translation>{} との接続が切れました: {}</translation>
    </message>
    <message>
        <source>{} does not take what is sent</source>
        <translation>{} が送信データを受け取りません</translation>
    </message>
    <message>
        <source>port</source>
        <translation>ポート</translation>
    </message>
    <message>
        <source>a device as in /dev/ttyUSB0@9600, or tcp://host:port</source>
        <translation>/dev/ttyUSB0@9600 のような機器、または tcp://host:port</translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation>抜けています</translation>
    </message>
    <message>
        <source>camera: unplugged</source>
        <translation>カメラ: 抜けています</translation>
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
        <source>no folder that can be read</source>
        <translation>読み取れないフォルダー</translation>
    </message>
    <message>
        <source>one with images</source>
        <translation>画像のあるフォルダー</translation>
    </message>
    <message>
        <source>the labels of {}</source>
        <translation>{} のラベル</translation>
    </message>
    <message>
        <source>a colour image</source>
        <translation>カラー画像</translation>
    </message>
    <message>
        <source>a grey one: a class number a pixel</source>
        <translation>グレー画像: 一画素に一つのクラス番号</translation>
    </message>
    <message>
        <source>{} pixels</source>
        <translation>{} 画素</translation>
    </message>
    <message>
        <source>{} as its image</source>
        <translation>対応する画像と同じ {}</translation>
    </message>
    <message>
        <source>--building-class: only with --model NAME.onnx</source>
        <translation>--building-class: --model NAME.onnx と一緒にのみ使えます</translation>
    </message>
    <message>
        <source>buildings</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>--faults: found &quot;{}&quot;, expected DEVICE:KIND@BEGIN+SECONDS</source>
        <translation>--faults: 「{}」(必要: DEVICE:KIND@BEGIN+SECONDS)</translation>
    </message>
    <message>
        <source>{}; e.g. {}</source>
        <translation>{}。例: {}</translation>
    </message>
    <message>
        <source>Along {:.0f} % of the way, none of the drawn buildings that were recognised is within the {:.0f} m that the sensor sees: there the way is that of the motion alone.</source>
        <translation>経路の {:.0f} % では、見分けられた建物がセンサーの届く {:.0f} m 以内に描かれていません。そこでの経路は動きだけによるものです。</translation>
    </message>
    <message>
        <source>{} If so, draw more of what stands along the way.</source>
        <translation>{} その場合は、経路沿いの建物をもっと描いてください。</translation>
    </message>
    <message>
        <source>the same scan again, though the robot has moved</source>
        <translation>ロボットは動いたのに同じスキャンがまた来ました</translation>
    </message>
    <message>
        <source>{}: found a file of the recording {}, expected another place for what is written</source>
        <translation>{}: 記録 {} のファイルです。書き込み先には別の場所が必要です</translation>
    </message>
    <message>
        <source>The correction on the way failed: {}</source>
        <translation>途中での補正に失敗しました: {}</translation>
    </message>
    <message>
        <source>The end of the run does not depend on it.</source>
        <translation>実行の最終結果には影響しません。</translation>
    </message>
    <message>
        <source>a web page of {} was turned away: &quot;origins&quot; in the rig file would let it look on</source>
        <translation>{} のウェブページを断りました。リグのファイルの &quot;origins&quot; に挙げれば見られます</translation>
    </message>
    <message>
        <source>too many observations that wait for odometry</source>
        <translation>オドメトリを待つ観測が多すぎます</translation>
    </message>
    <message>
        <source>odometry too far apart around an observation</source>
        <translation>観測の前後のオドメトリが離れすぎています</translation>
    </message>
    <message>
        <source>{}: found the arrays {}, expected to know which hold what</source>
        <translation>{}: 配列 {} がありました。どれが何を持つかが必要です</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>ROLE=ARRAY,… of ranges, points, time, poses, angles</source>
        <translation>役割=配列,… 役割は ranges、points、time、poses、angles</translation>
    </message>
    <message>
        <source>{} times</source>
        <translation>{} 個の時刻</translation>
    </message>
    <message>
        <source>{}: found no times, expected an array of them</source>
        <translation>{}: 時刻がありません。時刻の配列が必要です</translation>
    </message>
    <message>
        <source>how many scans a second there are</source>
        <translation>一秒あたりのスキャンの数</translation>
    </message>
    <message>
        <source>scans x ranges</source>
        <translation>スキャン x 距離</translation>
    </message>
    <message>
        <source>{}, one for each range</source>
        <translation>{} 個、距離ごとに一つ</translation>
    </message>
    <message>
        <source>scans x points x 2 to 4 (x y z w)</source>
        <translation>スキャン x 点 x 2 から 4（x y z w）</translation>
    </message>
    <message>
        <source>N x 3 (x y heading), N x 4 (time first) or N x 8 (time x y z qx qy qz qw)</source>
        <translation>N x 3（x y 方位）、N x 4（時刻が先頭）、または N x 8（time x y z qx qy qz qw）</translation>
    </message>
    <message>
        <source>a number in field {} of {}</source>
        <translation>欄 {} に数（{}）</translation>
    </message>
    <message>
        <source>how many ranges follow, at most {}</source>
        <translation>続く距離の数、最大 {}</translation>
    </message>
    <message>
        <source>{} scans and poses at a time that was there are left out</source>
        <translation>すでにある時刻のスキャンと姿勢 {} 個を除きました</translation>
    </message>
    <message>
        <source>{}: found no scan, expected some</source>
        <translation>{}: スキャンがありません。必要です</translation>
    </message>
    <message>
        <source>poses alone are no recording: give the scans, too</source>
        <translation>姿勢だけでは記録になりません。スキャンも与えてください</translation>
    </message>
    <message>
        <source>no poses: the scans are to tell the motion</source>
        <translation>姿勢なし: 動きはスキャンから求めます</translation>
    </message>
    <message>
        <source>{}: found poses from {} to {} s, expected those of the scans, {} to {} s</source>
        <translation>{}: 姿勢は {} から {} 秒です。スキャンの {} から {} 秒のものが必要です</translation>
    </message>
    <message>
        <source>{} scans before or after the poses are left out</source>
        <translation>姿勢の前後のスキャン {} 個を除きました</translation>
    </message>
    <message>
        <source>header</source>
        <translation>ヘッダー</translation>
    </message>
    <message>
        <source>an array of numpy</source>
        <translation>numpy の配列</translation>
    </message>
    <message>
        <source>real or whole numbers: f4 f8 i1 to i8 u1 to u8 b1</source>
        <translation>実数または整数: f4 f8 i1 から i8 u1 から u8 b1</translation>
    </message>
    <message>
        <source>no array</source>
        <translation>配列なし</translation>
    </message>
    <message>
        <source>a .npy of numpy</source>
        <translation>numpy の .npy</translation>
    </message>
    <message>
        <source>a whole header</source>
        <translation>完全なヘッダー</translation>
    </message>
    <message>
        <source>at most {} extents</source>
        <translation>最大 {} 次元</translation>
    </message>
    <message>
        <source>more values</source>
        <translation>それ以上の値</translation>
    </message>
    <message>
        <source>{} values of {} bytes</source>
        <translation>{} 個の値、それぞれ {} バイト</translation>
    </message>
    <message>
        <source>{} entries</source>
        <translation>{} 個の項目</translation>
    </message>
    <message>
        <source>a damaged directory</source>
        <translation>壊れた目録</translation>
    </message>
    <message>
        <source>a .npz as numpy saves it</source>
        <translation>numpy が保存した .npz</translation>
    </message>
    <message>
        <source>a file that is cut off</source>
        <translation>途中で切れたファイル</translation>
    </message>
    <message>
        <source>no directory</source>
        <translation>目録なし</translation>
    </message>
    <message>
        <source>an entry without its size</source>
        <translation>大きさのない項目</translation>
    </message>
    <message>
        <source>more than {} MB</source>
        <translation>{} MB を超える量</translation>
    </message>
    <message>
        <source>a damaged entry</source>
        <translation>壊れた項目</translation>
    </message>
    <message>
        <source>packing method {}</source>
        <translation>圧縮方式 {}</translation>
    </message>
    <message>
        <source>no memory</source>
        <translation>メモリー不足</translation>
    </message>
    <message>
        <source>damaged data</source>
        <translation>壊れたデータ</translation>
    </message>
    <message>
        <source>{}: lengths taken as centimetres</source>
        <translation>{}: 長さをセンチメートルとみなしました</translation>
    </message>
    <message>
        <source>{}: lengths taken as millimetres</source>
        <translation>{}: 長さをミリメートルとみなしました</translation>
    </message>
    <message>
        <source>{}: poses taken as metres</source>
        <translation>{}: 姿勢をメートルとみなしました</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>ミリ秒</translation>
    </message>
    <message>
        <source>microseconds</source>
        <translation>マイクロ秒</translation>
    </message>
    <message>
        <source>nanoseconds</source>
        <translation>ナノ秒</translation>
    </message>
    <message>
        <source>{}: times taken as {}</source>
        <translation>{}: 時刻を{}とみなしました</translation>
    </message>
    <message>
        <source>{}: headings taken as degrees</source>
        <translation>{}: 方位を度とみなしました</translation>
    </message>
    <message>
        <source>{}: {} ranges a scan taken as {:.1f}° to {:.1f}°, left is positive</source>
        <translation>{}: 一スキャン {} 個の距離を {:.1f}° から {:.1f}°（左が正）とみなしました</translation>
    </message>
    <message>
        <source>{}: found {} ranges a scan, expected the directions they look</source>
        <translation>{}: 一スキャンに {} 個の距離があります。それぞれの向きが必要です</translation>
    </message>
    <message>
        <source>FIRST:STEP in degrees, 0 ahead, positive to the left, as -90:0.5</source>
        <translation>最初:刻み（度、前が 0、左が正）、例 -90:0.5</translation>
    </message>
    <message>
        <source>{}: ranges from {:.2f} m on taken as nothing that came back</source>
        <translation>{}: {:.2f} m 以上の距離を「返りなし」とみなしました</translation>
    </message>
    <message>
        <source>{} columns</source>
        <translation>{} 列</translation>
    </message>
    <message>
        <source>{}, as the lines before have</source>
        <translation>前の行と同じ {}</translation>
    </message>
    <message>
        <source>rows of numbers</source>
        <translation>数の行</translation>
    </message>
    <message>
        <source>a column of {}: a number from 1 to {}, A-B, or one of {}</source>
        <translation>{} の列: 1 から {} の番号、A-B、または次のどれか: {}</translation>
    </message>
    <message>
        <source>{}: found the columns {}{}, expected to know which hold what</source>
        <translation>{}: 列 {}{} がありました。どれが何を持つかが必要です</translation>
    </message>
    <message>
        <source>ROLE=COLUMN,… as time=1,ranges=2-362 or time=t,x=px,y=py</source>
        <translation>役割=列,… 例 time=1,ranges=2-362 または time=t,x=px,y=py</translation>
    </message>
    <message>
        <source>{}: found no column of times, expected one</source>
        <translation>{}: 時刻の列がありません。必要です</translation>
    </message>
    <message>
        <source>{}: found x and y without a heading, expected one</source>
        <translation>{}: x と y に方位がありません。必要です</translation>
    </message>
    <message>
        <source>heading=COLUMN, or qx=…,qy=…,qz=…,qw=…</source>
        <translation>heading=列、または qx=…,qy=…,qz=…,qw=…</translation>
    </message>
    <message>
        <source>scans that lie {:.2f} m off each other along the odometry, but {:.2f} m</source>
        <translation>オドメトリに沿って互いに {:.2f} m ずれ、次の読み方なら {:.2f} m になるスキャン</translation>
    </message>
    <message>
        <source>{}: found {} with y the other way, expected both to turn alike</source>
        <translation>{}: {}（y を逆にした場合）がありました。両者は同じ向きに回るはずです</translation>
    </message>
    <message>
        <source>the sensor is mounted upside down or counts its angles clockwise (y of the points has the wrong sign), or the odometry turns the wrong way</source>
        <translation>センサーが逆さに付いているか、角度を時計回りに数えています（点の y の符号が逆）。またはオドメトリの回る向きが逆です</translation>
    </message>
    <message>
        <source>Read the points with y the other way</source>
        <translation>点の y を逆に読む</translation>
    </message>
    <message>
        <source>{}: found {} with other axes, expected x forward and y left</source>
        <translation>{}: {}（別の軸の場合）がありました。x は前、y は左のはずです</translation>
    </message>
    <message>
        <source>the points look like x right, y forward</source>
        <translation>点は x が右、y が前のようです</translation>
    </message>
    <message>
        <source>the points look turned around: x backwards</source>
        <translation>点は後ろ向きのようです: x が後ろ</translation>
    </message>
    <message>
        <source>Read the points as x right, y forward</source>
        <translation>点を x が右、y が前として読む</translation>
    </message>
    <message>
        <source>Turn the points around</source>
        <translation>点の向きを前後逆にする</translation>
    </message>
    <message>
        <source>{}: found {} with shorter motions, expected metres</source>
        <translation>{}: {}（動きが短い場合）がありました。メートルのはずです</translation>
    </message>
    <message>
        <source>these look like millimetres: multiply x and y by 0.001</source>
        <translation>ミリメートルのようです: x と y に 0.001 を掛けてください</translation>
    </message>
    <message>
        <source>these look like centimetres: multiply x and y by 0.01</source>
        <translation>センチメートルのようです: x と y に 0.01 を掛けてください</translation>
    </message>
    <message>
        <source>Read the odometry as millimetres</source>
        <translation>オドメトリをミリメートルとして読む</translation>
    </message>
    <message>
        <source>Read the odometry as centimetres</source>
        <translation>オドメトリをセンチメートルとして読む</translation>
    </message>
    <message>
        <source>these look like centimetres</source>
        <translation>センチメートルのようです</translation>
    </message>
    <message>
        <source>these look like millimetres</source>
        <translation>ミリメートルのようです</translation>
    </message>
    <message>
        <source>{}{}: found a key that nothing knows, expected {}</source>
        <translation>{}{}: 知られていないキーがあります。期待したもの: {}</translation>
    </message>
    <message>
        <source>without it the usual value holds</source>
        <translation>それがなければ既定の値になります</translation>
    </message>
    <message>
        <source>{}: building {}: </source>
        <translation>{}: 建物 {}: </translation>
    </message>
    <message>
        <source>{}: found a way that leads through its buildings on {:.0f} % of {:.0f} m, mirrored it would not, expected y up and headings counter-clockwise</source>
        <translation>{}: 道のりの {:.0f} %（{:.0f} m のうち）が建物の中を通り、鏡像なら通りません。y は上向き、方位は反時計回りのはずです</translation>
    </message>
    <message>
        <source>is y of the drawing down, as in pictures, or does the odometry turn the wrong way?</source>
        <translation>図面の y は画像のように下向きですか。またはオドメトリの回る向きが逆ですか。</translation>
    </message>
    <message>
        <source>{}: found a robot that drives {:.0f} m/s, expected metres</source>
        <translation>{}: ロボットが {:.0f} m/s で走っています。メートルのはずです</translation>
    </message>
    <message>
        <source>headings are counted from y: x looks right, y forward</source>
        <translation>方位が y から数えられています: x が右、y が前</translation>
    </message>
    <message>
        <source>Read the headings from y</source>
        <translation>方位を y から読む</translation>
    </message>
    <message>
        <source>x looks left or y backwards</source>
        <translation>x が左、または y が後ろを向いています</translation>
    </message>
    <message>
        <source>Turn the headings to the right</source>
        <translation>方位を右に 90° 回す</translation>
    </message>
    <message>
        <source>headings are counted clockwise</source>
        <translation>方位が時計回りに数えられています</translation>
    </message>
    <message>
        <source>Read the headings clockwise</source>
        <translation>方位を時計回りに読む</translation>
    </message>
    <message>
        <source>headings are those of a compass, clockwise from north</source>
        <translation>方位が羅針盤のものです（北から時計回り）</translation>
    </message>
    <message>
        <source>Read the headings as a compass&apos;s</source>
        <translation>方位を羅針盤のものとして読む</translation>
    </message>
    <message>
        <source>the robot drives backwards, or x looks back</source>
        <translation>ロボットが後ろ向きに走っているか、x が後ろを向いています</translation>
    </message>
    <message>
        <source>Turn the headings around</source>
        <translation>方位を前後逆にする</translation>
    </message>
    <message>
        <source>{}: found a robot that does not drive where it looks, expected headings counter-clockwise from x, x forward and y left</source>
        <translation>{}: ロボットが向いている方へ走っていません。方位は x から反時計回り、x は前、y は左のはずです</translation>
    </message>
    <message>
        <source>likely {}</source>
        <translation>おそらく: {}</translation>
    </message>
    <message>
        <source>{}: found one heading all along a way that turns, expected that of the robot</source>
        <translation>{}: 曲がる道のりでずっと同じ方位です。ロボットの方位のはずです</translation>
    </message>
    <message>
        <source>likely qx qy qz qw is not told (0 0 0 1), or w comes first</source>
        <translation>おそらく qx qy qz qw が与えられていない（0 0 0 1）か、w が先頭です</translation>
    </message>
    <message>
        <source>there the robot is taken to go straight at one speed; --odometry scan or visual tells more</source>
        <translation>そこではロボットが一定の速さで直進するとみなします。--odometry scan または visual がより詳しく教えます</translation>
    </message>
    <message>
        <source>{}: frame {}</source>
        <translation>{}: フレーム {}</translation>
    </message>
    <message>
        <source>{}: found half of the points farther away than {:.0f} m, expected metres</source>
        <translation>{}: 点の半分が {:.0f} m より遠くにあります。メートルのはずです</translation>
    </message>
    <message>
        <source>these look like centimetres: multiply x, y and z by 0.01</source>
        <translation>センチメートルのようです: x、y、z に 0.01 を掛けてください</translation>
    </message>
    <message>
        <source>these look like millimetres: multiply x, y and z by 0.001</source>
        <translation>ミリメートルのようです: x、y、z に 0.001 を掛けてください</translation>
    </message>
    <message>
        <source>Read the points as centimetres</source>
        <translation>点をセンチメートルとして読む</translation>
    </message>
    <message>
        <source>Read the points as millimetres</source>
        <translation>点をミリメートルとして読む</translation>
    </message>
    <message>
        <source>{}: range_limit_m: found {:.0f} % of the returns beyond {} m, where they are not used, expected the reach of the sensor</source>
        <translation>{}: range_limit_m: 返りの {:.0f} % が {} m より遠く、使われません。センサーの届く距離のはずです</translation>
    </message>
    <message>
        <source>&quot;range_limit_m&quot;: {} in recording.json takes them in</source>
        <translation>recording.json の &quot;range_limit_m&quot;: {} で使われます</translation>
    </message>
    <message>
        <source>See {} m far</source>
        <translation>{} m まで見る</translation>
    </message>
    <message>
        <source>{}: found the ground at z = {:.1f} m, expected it at 0</source>
        <translation>{}: 地面が z = {:.1f} m にあります。0 のはずです</translation>
    </message>
    <message>
        <source>z looks counted from the sensor: add its height, some {:.1f} m</source>
        <translation>z はセンサーから数えられているようです: その高さ約 {:.1f} m を足してください</translation>
    </message>
    <message>
        <source>Raise the points by {:.1f} m</source>
        <translation>点を {:.1f} m 上げる</translation>
    </message>
    <message>
        <source>{}: found w = 0 in all points: none of them counts, expected how surely each is on a building</source>
        <translation>{}: すべての点で w = 0 なので、どれも数えられません。建物にある確かさのはずです</translation>
    </message>
    <message>
        <source>where nothing is known of that, w is 1</source>
        <translation>分からないときは w は 1 です</translation>
    </message>
    <message>
        <source>was the folder copied whole?</source>
        <translation>フォルダーは完全に複写されましたか。</translation>
    </message>
    <message>
        <source>these look like {}: multiply time_s by {}</source>
        <translation>{}のようです: time_s に {} を掛けてください</translation>
    </message>
    <message>
        <source>Read the times as {}</source>
        <translation>時刻を{}として読む</translation>
    </message>
    <message>
        <source>the frames look like {}, the odometry like seconds</source>
        <translation>フレームは{}、オドメトリは秒のようです</translation>
    </message>
    <message>
        <source>the odometry looks like {}, the frames like seconds</source>
        <translation>オドメトリは{}、フレームは秒のようです</translation>
    </message>
    <message>
        <source>two clocks: the frames begin at {} s, the odometry at {} s; give both the same</source>
        <translation>二つの時計: フレームは {} 秒、オドメトリは {} 秒に始まります。同じ時計にしてください</translation>
    </message>
    <message>
        <source>{}: found times from {} to {} s, expected those of the frames, {} to {} s</source>
        <translation>{}: 時刻は {} から {} 秒です。フレームの {} から {} 秒のはずです</translation>
    </message>
    <message>
        <source>seconds; this looks like {}</source>
        <translation>秒。これは{}のようです</translation>
    </message>
    <message>
        <source>16 bytes a point (x y z w) or 12 (x y z)</source>
        <translation>一点 16 バイト（x y z w）または 12 バイト（x y z）</translation>
    </message>
    <message>
        <source>w from 0 to 1: how surely a point is on a building, no intensity</source>
        <translation>0 から 1 の w: 点が建物にある確かさ（反射強度ではありません）</translation>
    </message>
    <message>
        <source>{} bytes from byte {} on</source>
        <translation>{} バイト（バイト {} から）</translation>
    </message>
    <message>
        <source>no more bytes</source>
        <translation>それ以上のバイトなし</translation>
    </message>
    <message>
        <source>{}: {}: found a key that nothing knows, expected {}</source>
        <translation>{}: {}: 知られていないキーがあります。期待したもの: {}</translation>
    </message>
    <message>
        <source>a quaternion that tips the robot over, as {} of {} do</source>
        <translation>ロボットを倒す四元数（{} 個、全 {} 個のうち）</translation>
    </message>
    <message>
        <source>qx qy qz qw of x forward, y left, z up: is w the first of yours?</source>
        <translation>x が前、y が左、z が上の qx qy qz qw。w が先頭ではありませんか。</translation>
    </message>
    <message>
        <source>--columns: found &quot;{}&quot;, expected ROLE=COLUMN,…</source>
        <translation>--columns: 「{}」がありました。役割=列,… が必要です</translation>
    </message>
    <message>
        <source>--angles: found &quot;{}&quot;, expected FIRST:STEP in degrees</source>
        <translation>--angles: 「{}」がありました。最初:刻み（度）が必要です</translation>
    </message>
    <message>
        <source>no geographic data</source>
        <translation>地理データではないもの</translation>
    </message>
    <message>
        <source>damaged geographic data</source>
        <translation>壊れた地理データ</translation>
    </message>
    <message>
        <source>coordinates that lie nowhere on earth</source>
        <translation>地球上にない座標</translation>
    </message>
    <message>
        <source>the coordinates {}, {}</source>
        <translation>座標 {}, {}</translation>
    </message>
    <message>
        <source>longitude and latitude in degrees</source>
        <translation>度で表した経度と緯度</translation>
    </message>
    <message>
        <source>a file of geographic data</source>
        <translation>地理データのファイル</translation>
    </message>
    <message>
        <source>{}: this program was built without GDAL, which reads geographic data</source>
        <translation>{}：このプログラムは、地理データを読む GDAL なしで作られています</translation>
    </message>
    <message>
        <source>{} features and no building among them</source>
        <translation>{} 個の地物があり、建物は一つもない</translation>
    </message>
    <message>
        <source>polygons of buildings</source>
        <translation>建物の多角形</translation>
    </message>
    <message>
        <source>{} outlines that cross themselves or are too large</source>
        <translation>自分自身と交わるか、大きすぎる {} 個の輪郭</translation>
    </message>
    <message>
        <source>the other side closed the connection</source>
        <translation>相手が接続を閉じました</translation>
    </message>
    <message>
        <source>no odometry came: it is not known where</source>
        <translation>オドメトリが来ません: どこなのか分かりません</translation>
    </message>
    <message>
        <source>nothing was observed yet</source>
        <translation>まだ何も観測されていません</translation>
    </message>
    <message>
        <source>the drive has ended</source>
        <translation>走行は終わりました</translation>
    </message>
    <message>
        <source>nothing was observed for {:.0f} s</source>
        <translation>{:.0f} 秒間何も観測されていません</translation>
    </message>
    <message>
        <source>nine times of ten within {:.1f} m and {:.0f}°</source>
        <translation>十のうち九は {:.1f} m と {:.0f}° 以内</translation>
    </message>
    <message>
        <source>{} does not take what it is sent</source>
        <translation>{} は送ったものを受け取りません</translation>
    </message>
    <message>
        <source>Nothing of the drawing was recognised on the last {:.0f} m: the robot may have been elsewhere all the way, however well the buildings before fitted.</source>
        <translation>最後の {:.0f} m では図面のものが一つも認識されませんでした。それまでの建物がよく合っていても、ロボットはずっと別の場所にいたのかもしれません。</translation>
    </message>
    <message>
        <source>{}: buildings[{}]: found half of them longer than {:.0f} m, expected metres</source>
        <translation>{}: buildings[{}]: 建物の半分が {:.0f} m より長くなっています。メートルのはずです</translation>
    </message>
    <message>
        <source>{}: buildings: found what is seen {:.1f} m off their walls, mirrored {:.1f} m, expected y up and headings counter-clockwise</source>
        <translation>{}: buildings: 見えたものが壁から {:.1f} m ずれていますが、鏡に映すと {:.1f} m です。y は上向き、方位は反時計回りのはずです</translation>
    </message>
    <message>
        <source>is y of the drawing down, as in pictures, or do odometry and scans turn the wrong way?</source>
        <translation>図面の y が画像のように下向きか、オドメトリとスキャンが逆向きに回っていませんか。</translation>
    </message>
    <message>
        <source>{}: line {}</source>
        <translation>{}: {} 行目</translation>
    </message>
    <message>
        <source>{}: points: found {} of {} points files missing, the first here, expected all</source>
        <translation>{}: points: 点ファイルが {} 個（{} 個のうち）ありません。最初はここです。すべて必要です</translation>
    </message>
    <message>
        <source>{}: time_s: found {:.4g} s from frame to frame, expected seconds</source>
        <translation>{}: time_s: フレームの間が {:.4g} 秒です。秒のはずです</translation>
    </message>
    <message>
        <source>From there on the way may be off: give odometry, or drive more slowly where little is in sight.</source>
        <translation>そこから先の経路はずれているかもしれません。オドメトリを与えるか、見えるものが少ない所ではもっとゆっくり走ってください。</translation>
    </message>
    <message>
        <source>Nothing of the drawing was recognised for {:.0f} m on the way, up to {} s: nothing tells whether the robot was where it is shown there.</source>
        <translation>途中の {:.0f} m（{} 秒まで）では図面のものが一つも認識されませんでした。そこでロボットが示された場所にいたかどうかはわかりません。</translation>
    </message>
    <message>
        <source>Draw what stands there; where it is drawn, check the start.</source>
        <translation>そこにあるものを描いてください。描いてあるなら、出発点を確かめてください。</translation>
    </message>
    <message>
        <source>the sheet</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>{} × {} m</source>
        <translation>{} × {} m</translation>
    </message>
    <message>
        <source>at most 4800 × 3200 m</source>
        <translation>最大 4800 × 3200 m</translation>
    </message>
    <message>
        <source>the photo is dark</source>
        <translation>写真が暗すぎます</translation>
    </message>
    <message>
        <source>the photo has hardly a pixel</source>
        <translation>写真に画素がほとんどありません</translation>
    </message>
    <message>
        <source>the photo is blurred, or there is no ink on it</source>
        <translation>写真がぼけているか、何も描かれていません</translation>
    </message>
    <message>
        <source>no calibration</source>
        <translation>キャリブレーションがありません</translation>
    </message>
    <message>
        <source>that of both cameras</source>
        <translation>両方のカメラのもの</translation>
    </message>
    <message>
        <source>P of the right camera: {:.3f}</source>
        <translation>右カメラの P: {:.3f}</translation>
    </message>
    <message>
        <source>as the left one has it: {:.3f}</source>
        <translation>左カメラと同じ値: {:.3f}</translation>
    </message>
    <message>
        <source>a baseline of {:.3g} m</source>
        <translation>基線長 {:.3g} m</translation>
    </message>
    <message>
        <source>the right camera to the right</source>
        <translation>右カメラが右にあること</translation>
    </message>
    <message>
        <source>nothing tells where the camera is: taken to look ahead, {:.2f} m above the ground</source>
        <translation>カメラの位置が示されていません: 地上 {:.2f} m で前を向いているとみなします</translation>
    </message>
    <message>
        <source>{} messages cannot be read; the first: {}</source>
        <translation>{} 件のメッセージが読めません。最初のもの: {}</translation>
    </message>
    <message>
        <source>nothing tells where &quot;{}&quot; is on the robot: taken to be its origin</source>
        <translation>「{}」がロボットのどこにあるか示されていません: 原点にあるとみなします</translation>
    </message>
    <message>
        <source>no message can be read; the first: {}</source>
        <translation>読めるメッセージがありません。最初のもの: {}</translation>
    </message>
    <message>
        <source>more than {} bytes out of order</source>
        <translation>{} バイトを超える順序の乱れ</translation>
    </message>
    <message>
        <source>messages about in the order of their times</source>
        <translation>ほぼ時刻の順に並んだメッセージ</translation>
    </message>
    <message>
        <source>{}: found nothing that sees, expected scans, points or a pair of images with camera infos; it holds {}</source>
        <translation>{}: 周りを見るものがありません。スキャン、点群、または camera_info のある画像の組が必要です。中身: {}</translation>
    </message>
    <message>
        <source>the images have no camera_info beside them</source>
        <translation>画像のそばに camera_info がありません</translation>
    </message>
    <message>
        <source>{}: found no image or scan at a time that the odometry knows, expected some</source>
        <translation>{}: オドメトリのある時刻に画像もスキャンもありません</translation>
    </message>
    <message>
        <source>{} and {}: found both, expected one of them</source>
        <translation>{} と {}: 両方が指定されています。どちらか一つにしてください</translation>
    </message>
    <message>
        <source>none: there is no topic that could serve</source>
        <translation>none: 使えるトピックがありません</translation>
    </message>
    <message>
        <source>another ending</source>
        <translation>別の拡張子</translation>
    </message>
    <message>
        <source>messages in another encoding</source>
        <translation>別の符号化のメッセージ</translation>
    </message>
    <message>
        <source>one more topic</source>
        <translation>さらに一つのトピック</translation>
    </message>
    <message>
        <source>no bag in the folder</source>
        <translation>フォルダーにバッグがありません</translation>
    </message>
    <message>
        <source>the end of the file at {}</source>
        <translation>{} でファイルの終わり</translation>
    </message>
    <message>
        <source>representation {}</source>
        <translation>表現 {}</translation>
    </message>
    <message>
        <source>plain CDR</source>
        <translation>通常の CDR</translation>
    </message>
    <message>
        <source>{} × {} bytes</source>
        <translation>{} × {} バイト</translation>
    </message>
    <message>
        <source>another beginning</source>
        <translation>別の始まり</translation>
    </message>
    <message>
        <source>chunk at byte {}</source>
        <translation>バイト {} のチャンク</translation>
    </message>
    <message>
        <source>damaged bytes</source>
        <translation>壊れたバイト列</translation>
    </message>
    <message>
        <source>those of its checksum</source>
        <translation>チェックサムどおりのもの</translation>
    </message>
    <message>
        <source>{}: cut off at byte {}: what is before that is read</source>
        <translation>{}: バイト {} で途切れています: その前までを読みます</translation>
    </message>
    <message>
        <source>record at byte {}</source>
        <translation>バイト {} のレコード</translation>
    </message>
    <message>
        <source>more than {} bytes</source>
        <translation>{} バイトを超える大きさ</translation>
    </message>
    <message>
        <source>no field</source>
        <translation>フィールドがありません</translation>
    </message>
    <message>
        <source>even numbers</source>
        <translation>偶数</translation>
    </message>
    <message>
        <source>{} ranges</source>
        <translation>{} 個の距離</translation>
    </message>
    <message>
        <source>at most {} × {}</source>
        <translation>最大 {} × {}</translation>
    </message>
    <message>
        <source>the tables of a ROS 2 bag: topics, messages</source>
        <translation>ROS 2 のバッグの表: topics、messages</translation>
    </message>
    <message>
        <source>other tables</source>
        <translation>別の表</translation>
    </message>
    <message>
        <source>give the map a georeference before exporting it as {}</source>
        <translation>{} に書き出す前に地図に位置を与えてください</translation>
    </message>
    <message>
        <source>{}: this program was built without GDAL, which writes {}</source>
        <translation>{}: このプログラムは {} を書く GDAL なしで作られています</translation>
    </message>
    <message>
        <source>give the map a georeference before exporting it as OpenStreetMap</source>
        <translation>OpenStreetMap に書き出す前に地図に位置を与えてください</translation>
    </message>
    <message>
        <source>a whole picture, P5</source>
        <translation>完全な P5 の画像</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>別のもの</translation>
    </message>
    <message>
        <source>a map of map_server</source>
        <translation>map_server の地図</translation>
    </message>
    <message>
        <source>metres a pixel</source>
        <translation>一画素のメートル数</translation>
    </message>
    <message>
        <source>nothing that is occupied</source>
        <translation>占有された所がありません</translation>
    </message>
    <message>
        <source>pieces of at least {} m²</source>
        <translation>{} m² 以上のかたまり</translation>
    </message>
    <message>
        <source>{}: points: found the same scan again though the robot has moved, so {} of {} looked at, the first here, expected what is seen from there</source>
        <translation>{0}: points: ロボットが動いたのに同じスキャンが繰り返されています（調べた {2} 組のうち {1} 組、最初がここ）。その場所から見えるものが必要です</translation>
    </message>
    <message>
        <source>did the scanner freeze, or do rows name one file again and again?</source>
        <translation>スキャナーが固まっていませんか、または複数の行が同じファイルを指していませんか</translation>
    </message>
    <message>
        <source>nothing has come of {} yet: is that its name, and is it sent?</source>
        <translation>{} からまだ何も届いていません: その名前で正しいですか、送信されていますか</translation>
    </message>
    <message>
        <source>{}: found {} with the rays over {:.3g} times the angle, expected each ray where it looked</source>
        <translation>{}: {}（光線の角度を {:.3g} 倍にした場合）がありました。それぞれの光線の正しい向きが必要です</translation>
    </message>
    <message>
        <source>was another field of view meant, as 270° and not 180°? --angles of import says it</source>
        <translation>視野が違いませんか（180° でなく 270° など）。import の --angles で指定します</translation>
    </message>
    <message>
        <source>this bridge takes no messages of ROS 2: ROS is not told anything</source>
        <translation>このブリッジは ROS 2 のメッセージを受け取りません。ROS には何も伝わりません</translation>
    </message>
    <message>
        <source>too many types</source>
        <translation>型が多すぎる</translation>
    </message>
    <message>
        <source>too many fields</source>
        <translation>項目が多すぎる</translation>
    </message>
    <message>
        <source>a type and a name</source>
        <translation>型と名前</translation>
    </message>
    <message>
        <source>a type that is told</source>
        <translation>説明のある型</translation>
    </message>
    <message>
        <source>image over ROS</source>
        <translation>ROS 経由の画像</translation>
    </message>
    <message>
        <source>connecting to ROS</source>
        <translation>ROS に接続しています</translation>
    </message>
    <message>
        <source>a later time, 2011-09-26 13:02:25.594360375</source>
        <translation>より後の時刻、2011-09-26 13:02:25.594360375</translation>
    </message>
    <message>
        <source>latitude, longitude, altitude, roll, pitch and yaw</source>
        <translation>緯度、経度、高度、ロール、ピッチ、ヨー</translation>
    </message>
    <message>
        <source>latitude and longitude in degrees</source>
        <translation>度で書かれた緯度と経度</translation>
    </message>
    <message>
        <source>a multiple of {}</source>
        <translation>{} の倍数</translation>
    </message>
    <message>
        <source>no such file, nor in the folder above</source>
        <translation>そのファイルがなく、上のフォルダーにもない</translation>
    </message>
    <message>
        <source>the calibration of that day beside the drive</source>
        <translation>走行の隣にその日の較正ファイル</translation>
    </message>
    <message>
        <source>the true way is that of the inertial unit, not of the camera</source>
        <translation>真の道のりはカメラではなく慣性装置のものです</translation>
    </message>
    <message>
        <source>a drive that is not rectified</source>
        <translation>平行化されていない走行</translation>
    </message>
    <message>
        <source>the synchronized and rectified one, …_sync</source>
        <translation>同期され平行化された走行、…_sync</translation>
    </message>
    <message>
        <source>neither pairs of images nor scans</source>
        <translation>画像の組もスキャンもない</translation>
    </message>
    <message>
        <source>no odometry: the images are to tell the motion</source>
        <translation>オドメトリがありません。動きは画像から求めます</translation>
    </message>
    <message>
        <source>no such video can be made here</source>
        <translation>このような動画はここでは作れません</translation>
    </message>
    <message>
        <source>it is not empty</source>
        <translation>空ではありません</translation>
    </message>
    <message>
        <source>no printed sheet under the map</source>
        <translation>地図の下に印刷した用紙がありません</translation>
    </message>
    <message>
        <source>a map that was drawn on one</source>
        <translation>用紙に描いた地図</translation>
    </message>
    <message>
        <source>nothing comes of {} any more</source>
        <translation>{} が届かなくなりました</translation>
    </message>
    <message>
        <source>{}: found gaps with frames in them: {}, the longest of {:.1f} s from {} s on, expected a pose each {:.2g} s</source>
        <translation>{}: フレームのある間に途切れが {} か所あります。最長は {:.1f} 秒（{} 秒から）。{:.2g} 秒ごとの姿勢のはずです</translation>
    </message>
    <message>
        <source>{}: poses taken as millimetres</source>
        <translation>{}: 姿勢の長さをミリメートルとみなしました</translation>
    </message>
    <message>
        <source>the sensor looks turned on the robot by {:.0f}°</source>
        <translation>センサーがロボット上で {:.0f}° 回って取り付けられているようです</translation>
    </message>
    <message>
        <source>Turn the points by {:.0f}°</source>
        <translation>点を {:.0f}° 回す</translation>
    </message>
    <message>
        <source>Nothing told the motion at {} of {} observations, first at {} s: what was seen there has too little in common with what was seen before, or only goes along the way.</source>
        <translation>{} 個の観測（{} 個のうち）では動きを伝えるものがありませんでした。最初は {} 秒です。そこで見えたものは、それまでに見えたものと共通点が少なすぎるか、道に沿って続くものだけです。</translation>
    </message>
    <message>
        <source>buildings that are not there</source>
        <translation>実在しない建物</translation>
    </message>
    <message>
        <source>room for {} beside the route</source>
        <translation>経路の脇に {} 棟分の場所</translation>
    </message>
    <message>
        <source>buildings to leave out</source>
        <translation>描き落とす建物</translation>
    </message>
    <message>
        <source>more than {}</source>
        <translation>{} より多く</translation>
    </message>
    <message>
        <source>start</source>
        <translation>出発点</translation>
    </message>
    <message>
        <source>one that can be off</source>
        <translation>ずらせる出発点</translation>
    </message>
    <message>
        <source>4 bytes for each of {} points</source>
        <translation>{} 個の点それぞれに 4 バイト</translation>
    </message>
    <message>
        <source>{} maps of robots</source>
        <translation>ロボットの地図が {} 枚</translation>
    </message>
    <message>
        <source>one, laid on the drawing</source>
        <translation>図面に合わせて置いたもの一枚</translation>
    </message>
    <message>
        <source>above free_thresh, both in 0 … 1</source>
        <translation>free_thresh より大きい値（どちらも 0 … 1）</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>--sensor: found &quot;{}&quot;, expected X,Y,Z in metres and perhaps a turn to the left in degrees</source>
        <translation>--sensor: 「{}」でした。X,Y,Z（メートル）と、必要なら左への向き（度）にしてください</translation>
    </message>
    <message>
        <source>at most {} pixels</source>
        <translation>多くても {} ピクセル</translation>
    </message>
    <message>
        <source>GeoJSON, OpenStreetMap XML, GeoPackage, Shapefile, KML, GML or DXF</source>
        <translation>GeoJSON、OpenStreetMap XML、GeoPackage、Shapefile、KML、GML、または DXF</translation>
    </message>
    <message>
        <source>that of the rig or of the robot</source>
        <translation>リグまたはロボットの校正</translation>
    </message>
    <message>
        <source>nothing has come of {}, and the rig names no calibration</source>
        <translation>{} から何も届いておらず、リグに校正の指定もありません</translation>
    </message>
    <message>
        <source>the disk took but a part of it</source>
        <translation>ディスクに一部しか書けませんでした</translation>
    </message>
    <message>
        <source>The poses that were given do not go with the drawn start: the run began {:.1f} m and {:.0f}° off it.</source>
        <translation>与えられた姿勢は描かれた開始位置と合いません。走行はそこから {:.1f} m、{:.0f}° ずれた所で始まりました。</translation>
    </message>
    <message>
        <source>If the start is right, take the given poses back.</source>
        <translation>開始位置が正しければ、与えた姿勢を取り消してください。</translation>
    </message>
    <message>
        <source>{}: found headings that are those of the way in degrees, taken for radians, expected qz = sin(h/2) and qw = cos(h/2) of h in radians</source>
        <translation>{}: 度で表した進む方向をラジアンとみなした方位です。h をラジアンとした qz = sin(h/2)、qw = cos(h/2) であるべきです</translation>
    </message>
    <message>
        <source>turn degrees into radians where the quaternions are made</source>
        <translation>クォータニオンを作るところで、度をラジアンに直してください</translation>
    </message>
    <message>
        <source>{} × {} cells of {} m</source>
        <translation>{} × {} セル（一辺 {} m）</translation>
    </message>
    <message>
        <source>The drawn buildings together say that the run began {:.1f} m and {:.0f}° off the drawn start: they were believed.</source>
        <translation>描かれた建物はそろって、走行が描かれた開始位置から {:.1f} m、{:.0f}° ずれた所で始まったと示しています。建物を信じました。</translation>
    </message>
    <message>
        <source>Correct the start, or state how sure it is.</source>
        <translation>開始位置を直すか、その確かさを指定してください。</translation>
    </message>
    <message>
        <source>The drive did not begin where it was said to: what the robot saw there is not what it had seen there before.</source>
        <translation>走行は、示された場所から始まっていません。そこでロボットが見たものは、以前そこで見たものと違います。</translation>
    </message>
    <message>
        <source>Say with “Robot is here” where it was, or run the recording with another start.</source>
        <translation>「ロボットはここ」でロボットがいた場所を示すか、別の出発点で記録を実行してください。</translation>
    </message>
    <message>
        <source>the head looks around: {} of {}</source>
        <translation>雲台で見回し中: {1} のうち {0}</translation>
    </message>
    <message>
        <source>the head looks around when the robot stands</source>
        <translation>ロボットが止まったら雲台で見回します</translation>
    </message>
    <message>
        <source>{}: columns that nothing is made of: {}{}</source>
        <translation>{}: 使われない列: {}{}</translation>
    </message>
    <message>
        <source>Some drawn buildings were found on the way, but few walls stand where they would be: they were dropped.</source>
        <translation>途中で描かれた建物をいくつか見つけましたが、そこにあるはずの壁がほとんど見えませんでした。見つけた結果は捨てました。</translation>
    </message>
    <message>
        <source>Drive closer to the buildings, or with a sensor that sees more of their walls.</source>
        <translation>建物のもっと近くを走るか、壁がもっとよく見えるセンサーを使ってください。</translation>
    </message>
    <message>
        <source> The cameras saw no wall beyond {:.0f} m: farther away they are too imprecise.</source>
        <translation> カメラは {:.0f} m より遠くの壁を見ていません。それより遠くでは精度が足りません。</translation>
    </message>
    <message>
        <source>Drive closer to the walls, or with cameras that are farther apart or have more pixels.</source>
        <translation>壁のもっと近くを走るか、間隔のより広い、または画素数のより多いカメラを使ってください。</translation>
    </message>
</context>
<context>
    <name>handmap::Application</name>
    <message>
        <source>It was left undone; the program goes on.</source>
        <translation>その操作は行われませんでした。プログラムは続きます。</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>この操作にはメモリが足りません。</translation>
    </message>
    <message>
        <source>Something unexpected went wrong: %1</source>
        <translation>予期しない問題が起きました: %1</translation>
    </message>
    <message>
        <source>Something unexpected went wrong.</source>
        <translation>予期しない問題が起きました。</translation>
    </message>
</context>
<context>
    <name>handmap::BagDialog</name>
    <message>
        <source>Reading…</source>
        <translation>読んでいます…</translation>
    </message>
    <message>
        <source>Import a bag of ROS</source>
        <translation>ROS のバッグを取り込む</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>取り込む…</translation>
    </message>
    <message>
        <source>Left images</source>
        <translation>左の画像</translation>
    </message>
    <message>
        <source>Right images</source>
        <translation>右の画像</translation>
    </message>
    <message>
        <source>Laser scan</source>
        <translation>レーザースキャン</translation>
    </message>
    <message>
        <source>Point cloud</source>
        <translation>点群</translation>
    </message>
    <message>
        <source>Odometry</source>
        <translation>オドメトリ</translation>
    </message>
    <message>
        <source>True poses</source>
        <translation>真の姿勢</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n message(s))</source>
        <translation>
            <numerusform>%1（%n 件）</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing in it sees: choose a scan, points, or a pair of images that have camera infos beside them.</source>
        <translation>周りを見るものがありません: スキャン、点群、または camera_info のある画像の組を選んでください。</translation>
    </message>
    <message>
        <source>Nothing in it sees: it has neither scans nor points nor images.</source>
        <translation>見るものがありません。スキャンも点群も画像も入っていません。</translation>
    </message>
    <message>
        <source>as the bag says; else x,y,z, e.g. 0.3,0,1.7</source>
        <translation>バッグのとおり。なければ x,y,z、例: 0.3,0,1.7</translation>
    </message>
    <message>
        <source>Where on the robot the scanner or camera is: ahead, left, up, metres, and how far it is turned to the left, degrees.</source>
        <translation>スキャナーまたはカメラがロボットのどこにあるか: 前、左、上（メートル）、左への向き（度）。</translation>
    </message>
    <message>
        <source>Place of the sensor</source>
        <translation>センサーの位置</translation>
    </message>
</context>
<context>
    <name>handmap::BudgetTable</name>
    <message>
        <source>Stage</source>
        <translation>段階</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>割合</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中央値</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95 % はこれ以下</translation>
    </message>
    <message>
        <source>all</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Where the time of an observation goes</source>
        <translation>一観測の時間の内訳</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>A frame comes every %1 ms; 95 of 100 frames need at most %2 % of that.</source>
        <translation>フレームは %1 ms ごとに届きます。100 フレーム中 95 は、その %2 % 以下を使います。</translation>
    </message>
    <message>
        <source>A frame comes every %1 ms: too slow to keep up (95 of 100 frames need at most %2 % of that).</source>
        <translation>フレームは %1 ms ごとに届きます。処理が追いつきません (100 フレーム中 95 は、その %2 % 以下)。</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>読み込み</translation>
    </message>
    <message>
        <source>stereo</source>
        <translation>ステレオ</translation>
    </message>
    <message>
        <source>buildings in images</source>
        <translation>画像の建物</translation>
    </message>
    <message>
        <source>walls around</source>
        <translation>周りの壁</translation>
    </message>
    <message>
        <source>finding and correcting</source>
        <translation>位置決めと補正</translation>
    </message>
</context>
<context>
    <name>handmap::BuildingPage</name>
    <message>
        <source>Building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name Building</source>
        <translation>建物に名前を付ける</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>Change x</source>
        <translation>x を変更</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Change y</source>
        <translation>y を変更</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Change Width</source>
        <translation>幅を変更</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>奥行き</translation>
    </message>
    <message>
        <source>Change Depth</source>
        <translation>奥行きを変更</translation>
    </message>
    <message>
        <source>Change Heading</source>
        <translation>向きを変更</translation>
    </message>
    <message>
        <source>Fixed: a run must not move it</source>
        <translation>固定: 実行中に動かさない</translation>
    </message>
    <message>
        <source>Fix Building</source>
        <translation>建物を固定</translation>
    </message>
    <message>
        <source>May not exist</source>
        <translation>存在しないかもしれない</translation>
    </message>
    <message>
        <source>Doubt Building</source>
        <translation>建物の存在を疑う</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>推定</translation>
    </message>
    <message>
        <source>Uncertainty of its own</source>
        <translation>この建物だけの不確かさ</translation>
    </message>
    <message>
        <source>Change Uncertainty</source>
        <translation>不確かさを変更</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>描いた確かさ</translation>
    </message>
    <message>
        <source>Position ±</source>
        <translation>位置 ±</translation>
    </message>
    <message>
        <source>Size ±</source>
        <translation>大きさ ±</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>角</translation>
    </message>
    <message>
        <source>Change Corners</source>
        <translation>角を変更</translation>
    </message>
    <message>
        <source>&lt;b&gt;Building&lt;/b&gt;</source>
        <translation>&lt;b&gt;建物&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 Buildings&lt;/b&gt;</source>
        <translation>&lt;b&gt;建物 %1 棟&lt;/b&gt;</translation>
    </message>
    <message>
        <source>several</source>
        <translation>複数</translation>
    </message>
    <message>
        <source>—</source>
        <translation>—</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>x ±%1 m, y ±%2 m, width ±%3 m
Observations: %4</source>
        <translation>x ±%1 m、y ±%2 m、幅 ±%3 m
観測: %4</translation>
    </message>
    <message>
        <source>Locked against changes by hand</source>
        <translation>ロック: 手では変えられない</translation>
    </message>
    <message>
        <source>Lock Building</source>
        <translation>建物をロック</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>手書き</translation>
    </message>
</context>
<context>
    <name>handmap::BuildingsModel</name>
    <message>
        <source>Building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>Id and name in the drawing</source>
        <translation>図面の ID と名前</translation>
    </message>
    <message>
        <source>Moved
(m)</source>
        <translation>移動
(m)</translation>
    </message>
    <message>
        <source>From the drawn to the corrected middle</source>
        <translation>描いた中心から補正した中心まで</translation>
    </message>
    <message>
        <source>Doubt
(%)</source>
        <translation>疑い
(%)</translation>
    </message>
    <message>
        <source>± right
(m)</source>
        <translation>± 右
(m)</translation>
    </message>
    <message>
        <source>Standard deviation of the wall that faces right on the map; in brackets where nobody saw it</source>
        <translation>地図で右を向く壁の標準偏差。誰も見ていない場合は括弧付き</translation>
    </message>
    <message>
        <source>± up
(m)</source>
        <translation>± 上
(m)</translation>
    </message>
    <message>
        <source>Standard deviation of the wall that faces up on the map; in brackets where nobody saw it</source>
        <translation>地図で上を向く壁の標準偏差。誰も見ていない場合は括弧付き</translation>
    </message>
    <message>
        <source>± left
(m)</source>
        <translation>± 左
(m)</translation>
    </message>
    <message>
        <source>Standard deviation of the wall that faces left on the map; in brackets where nobody saw it</source>
        <translation>地図で左を向く壁の標準偏差。誰も見ていない場合は括弧付き</translation>
    </message>
    <message>
        <source>± down
(m)</source>
        <translation>± 下
(m)</translation>
    </message>
    <message>
        <source>Standard deviation of the wall that faces down on the map; in brackets where nobody saw it</source>
        <translation>地図で下を向く壁の標準偏差。誰も見ていない場合は括弧付き</translation>
    </message>
    <message>
        <source>Seen
(times)</source>
        <translation>観測
(回)</translation>
    </message>
    <message>
        <source>In how many observations it was seen</source>
        <translation>見えた観測の数</translation>
    </message>
    <message>
        <source>Off
(m)</source>
        <translation>誤差
(m)</translation>
    </message>
    <message>
        <source>From the corrected to the true middle</source>
        <translation>補正した中心から真の中心まで</translation>
    </message>
    <message>
        <source>Drawn x
(m)</source>
        <translation>描いた x
(m)</translation>
    </message>
    <message>
        <source>Middle of the drawn building</source>
        <translation>描いた建物の中心</translation>
    </message>
    <message>
        <source>Drawn y
(m)</source>
        <translation>描いた y
(m)</translation>
    </message>
    <message>
        <source>Now x
(m)</source>
        <translation>現在の x
(m)</translation>
    </message>
    <message>
        <source>Middle of the corrected building</source>
        <translation>補正した建物の中心</translation>
    </message>
    <message>
        <source>Now y
(m)</source>
        <translation>現在の y
(m)</translation>
    </message>
    <message>
        <source>Wider
(m)</source>
        <translation>幅の差
(m)</translation>
    </message>
    <message>
        <source>Corrected minus drawn width, along its heading</source>
        <translation>向きに沿った補正後の幅と描いた幅の差</translation>
    </message>
    <message>
        <source>Deeper
(m)</source>
        <translation>奥行きの差
(m)</translation>
    </message>
    <message>
        <source>Corrected minus drawn depth</source>
        <translation>補正後の奥行きと描いた奥行きの差</translation>
    </message>
    <message>
        <source>Turned
(°)</source>
        <translation>回転
(°)</translation>
    </message>
    <message>
        <source>Counter-clockwise, against the drawing</source>
        <translation>図面に対して反時計回り</translation>
    </message>
    <message>
        <source>Sure to
(m)</source>
        <translation>確かさ
(m)</translation>
    </message>
    <message>
        <source>One standard deviation of the least sure wall that was seen</source>
        <translation>見えた壁のうち最も不確かなものの標準偏差</translation>
    </message>
    <message>
        <source>Why doubtful</source>
        <translation>疑わしい理由</translation>
    </message>
    <message>
        <source>What speaks against taking it over</source>
        <translation>取り込まないほうがよい理由</translation>
    </message>
    <message>
        <source>Of 100 buildings with such signs so many were wrong: another one, or none, stood there</source>
        <translation>このような兆候の建物 100 棟のうち、誤りだった数: 別の建物が立っていたか、何もなかった</translation>
    </message>
    <message>
        <source>; </source>
        <translation>；</translation>
    </message>
</context>
<context>
    <name>handmap::BuildingsPanel</name>
    <message>
        <source>Corrected buildings</source>
        <translation>補正した建物</translation>
    </message>
    <message>
        <source>&amp;Copy as CSV</source>
        <translation>CSV としてコピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;All figures</source>
        <translation>すべての数値(&amp;A)</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Accept %1 of %2</source>
        <translation>%2 件中 %1 件を取り込む</translation>
    </message>
</context>
<context>
    <name>handmap::CalibrationDialog</name>
    <message>
        <source>Calibrate cameras</source>
        <translation>カメラの校正</translation>
    </message>
    <message>
        <source>Print a checkerboard, glue it on something flat, and measure its squares. Press Start and hold it before both cameras: what is needed is taken by itself.</source>
        <translation>市松模様を印刷して平らな板に貼り、升目の大きさを測ってください。「開始」を押し、両方のカメラの前にかざすと、必要な画像が自動で撮られます。</translation>
    </message>
    <message>
        <source>A device (/dev/video0), a video file, or the URL of a network camera</source>
        <translation>装置（/dev/video0）、動画ファイル、またはネットワークカメラの URL</translation>
    </message>
    <message>
        <source>none: both images in one</source>
        <translation>なし：1枚に両方の画像</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Right camera</source>
        <translation>右カメラ</translation>
    </message>
    <message>
        <source>Where four squares meet: one less than there are squares</source>
        <translation>4つの升目が接する点の数。升目の数より1少ない</translation>
    </message>
    <message>
        <source>Inner corners across</source>
        <translation>内側の角の数（横）</translation>
    </message>
    <message>
        <source>Inner corners down</source>
        <translation>内側の角の数（縦）</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The side of a square, measured: all distances hang on it</source>
        <translation>測った升目の一辺。すべての距離がこれで決まります</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>升目</translation>
    </message>
    <message>
        <source>not kept</source>
        <translation>保存しない</translation>
    </message>
    <message>
        <source>For “handmap-cli calibrate”, to do it again with the same pictures</source>
        <translation>「handmap-cli calibrate」で同じ画像からやり直すため</translation>
    </message>
    <message>
        <source>Keep pictures in</source>
        <translation>画像の保存先</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>フォルダーを選ぶ</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>開始(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Calibrate now</source>
        <translation>今すぐ校正(&amp;C)</translation>
    </message>
    <message>
        <source>Save and &amp;use…</source>
        <translation>保存して使う(&amp;U)…</translation>
    </message>
    <message>
        <source>Choose a camera.</source>
        <translation>カメラを選んでください。</translation>
    </message>
    <message>
        <source>A board with as many corners across as down does not tell which side is up: use another one.</source>
        <translation>角の数が縦横同じ板では上下がわかりません。別の板を使ってください。</translation>
    </message>
    <message>
        <source>Waiting for the first picture</source>
        <translation>最初の画像を待っています</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Calibrating: this takes some seconds.</source>
        <translation>校正しています。数秒かかります。</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>もう一度開始(&amp;S)</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%2 組のうち %1 組</translation>
    </message>
    <message>
        <source>Save the calibration</source>
        <translation>校正結果の保存</translation>
    </message>
    <message>
        <source>Calibrations (*.yml)</source>
        <translation>校正ファイル (*.yml)</translation>
    </message>
</context>
<context>
    <name>handmap::CameraPanel</name>
    <message>
        <source>No camera image yet</source>
        <translation>カメラ画像はまだありません</translation>
    </message>
    <message>
        <source>Camera: %1</source>
        <translation>カメラ: %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Frame %1 · %2 s</source>
        <translation>フレーム %1 · %2 秒</translation>
    </message>
    <message>
        <source>Frame %1, the last that is kept before frame %2</source>
        <translation>フレーム %1 (フレーム %2 より前に残る最後のもの)</translation>
    </message>
    <message>
        <source> · %1 % building</source>
        <translation> · 建物 %1 %</translation>
    </message>
    <message>
        <source> · looks %1° (%2 of %3)</source>
        <translation> · 向き %1° (%2/%3)</translation>
    </message>
    <message numerus="yes">
        <source> · %n window(s) placed the wall</source>
        <translation>
            <numerusform> · この壁を決めた窓 %n 個</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::CanvasChips</name>
    <message>
        <source>What points snap to: click for the next</source>
        <translation>点が吸い付く相手: クリックで次へ</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Take the last point back (Backspace)</source>
        <translation>最後の点を取り消す (Backspace)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Drop what is begun (Esc)</source>
        <translation>描きかけを捨てる (Esc)</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Finish what is drawn (Enter)</source>
        <translation>描いているものを完了 (Enter)</translation>
    </message>
</context>
<context>
    <name>handmap::ChangesItem</name>
    <message>
        <source>moved %1 m</source>
        <translation>%1 m 移動</translation>
    </message>
</context>
<context>
    <name>handmap::ChartsPanel</name>
    <message>
        <source>Particles that count (effective sample size)</source>
        <translation>効いている粒子の数 (有効サンプル数)</translation>
    </message>
    <message>
        <source>Time per observation (ms)</source>
        <translation>観測ごとの時間 (ms)</translation>
    </message>
    <message>
        <source>Robot: how sure its place is, and how far off (m)</source>
        <translation>ロボットの位置: 確かさと誤差 (m)</translation>
    </message>
    <message>
        <source>Buildings: how far from the drawn place (m)</source>
        <translation>建物: 描いた場所からの距離 (m)</translation>
    </message>
    <message>
        <source>Buildings: how far from the true place, mean (m)</source>
        <translation>建物: 真の場所からの平均距離 (m)</translation>
    </message>
    <message>
        <source>╍ true error</source>
        <translation>╍ 真の誤差</translation>
    </message>
    <message>
        <source>How well what was seen fits the map (higher: better)</source>
        <translation>見えたものと地図との合い方 (高いほど良い)</translation>
    </message>
    <message>
        <source>━ nine times of ten it is no farther off</source>
        <translation>━ 十回に九回、誤差はこれ以下</translation>
    </message>
</context>
<context>
    <name>handmap::Comfort</name>
    <message>
        <source>Draw</source>
        <translation>描く</translation>
    </message>
    <message>
        <source>Take the rectangle (R) and drag from corner to corner where you remember a building. It need not be right: some metres off is fine.</source>
        <translation>長方形ツール (R) で、建物を覚えている場所に角から角へドラッグします。正確でなくてかまいません。数メートルずれていても大丈夫です。</translation>
    </message>
    <message>
        <source>Say where the robot starts</source>
        <translation>ロボットの出発点を示す</translation>
    </message>
    <message>
        <source>With the start tool (T), press where the robot will stand and drag to where it will look. The wheel zooms, the middle button moves the view.</source>
        <translation>出発点ツール (T) で、ロボットが立つ場所を押し、見る方向へドラッグします。ホイールで拡大縮小、中ボタンで表示を移動します。</translation>
    </message>
    <message>
        <source>See what is missing</source>
        <translation>足りないものを見る</translation>
    </message>
    <message>
        <source>Issues lists what in the drawing is likely to be a slip; a click shows where.</source>
        <translation>「問題」には、図面の間違いらしいものが並びます。クリックするとその場所が表示されます。</translation>
    </message>
    <message>
        <source>Let a robot drive</source>
        <translation>ロボットを走らせる</translation>
    </message>
    <message>
        <source>Open a recording, connect a robot or take the simulator, then press Run: the blue map is the drawing as the robot corrects it.</source>
        <translation>記録を開くか、ロボットを接続するか、シミュレーターを選び、「実行」を押します。青い地図は、ロボットが補正している図面です。</translation>
    </message>
    <message>
        <source>Take the correction over</source>
        <translation>補正を取り込む</translation>
    </message>
    <message>
        <source>Accept Correction takes the blue map into the drawing; one Undo takes it back. Then save or export it.</source>
        <translation>「補正を取り込む」で青い地図が図面に入ります。「元に戻す」一回で取り消せます。その後、保存または書き出します。</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外観(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
</context>
<context>
    <name>handmap::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>何をしますか?</translation>
    </message>
    <message>
        <source>Commands that match</source>
        <translation>一致するコマンド</translation>
    </message>
    <message>
        <source>No command is called “%1”.</source>
        <translation>「%1」というコマンドはありません。</translation>
    </message>
</context>
<context>
    <name>handmap::CompareActions</name>
    <message>
        <source>the truth of the simulator</source>
        <translation>シミュレーターの真値</translation>
    </message>
    <message>
        <source>Open the true map</source>
        <translation>正しい地図を開く</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>「%1」</translation>
    </message>
    <message numerus="yes">
        <source>The drawing and %1 have too little in common: %n building(s) or landmark(s), and three are needed.</source>
        <translation>
            <numerusform>図面と%1に共通のものが少なすぎます。建物と目印は %n 個で、三個が必要です。</numerusform>
        </translation>
    </message>
    <message>
        <source>Another true map…</source>
        <translation>別の正しい地図…</translation>
    </message>
    <message>
        <source>Save the figures</source>
        <translation>数値を保存</translation>
    </message>
    <message>
        <source>-figures</source>
        <translation>-数値</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>The table of figures</source>
        <translation>数値の表</translation>
    </message>
    <message>
        <source>They are matched by the id that the file has, not by name.</source>
        <translation>名前ではなく、ファイルにある id で対応を取ります。</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>図面の比較</translation>
    </message>
</context>
<context>
    <name>handmap::ComparisonPanel</name>
    <message>
        <source>Figures of the drawing</source>
        <translation>図面の数値</translation>
    </message>
    <message>
        <source>&amp;Save as CSV…</source>
        <translation>CSV として保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Another True Map…</source>
        <translation>別の正しい地図(&amp;A)…</translation>
    </message>
    <message>
        <source>Against %1. The arrows lead from the true places to the drawn ones; a ring alone is not drawn. What each figure says stands in its tooltip.</source>
        <translation>%1と比べています。矢印は正しい位置から描かれた位置へ向かい、輪だけの所は描かれていません。数値の意味はツールチップにあります。</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>図面</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>補正後</translation>
    </message>
</context>
<context>
    <name>handmap::DiskWatch</name>
    <message>
        <source>“%1” is gone, or cannot be read any more.</source>
        <translation>「%1」がなくなったか、読めなくなりました。</translation>
    </message>
    <message>
        <source>What is drawn is still here; save it.</source>
        <translation>描いたものはここに残っています。保存してください。</translation>
    </message>
    <message>
        <source>Another program has changed “%1”.</source>
        <translation>別のプログラムが「%1」を変更しました。</translation>
    </message>
    <message>
        <source>There are unsaved changes here too.</source>
        <translation>ここにも保存していない変更があります。</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>読み直す</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>自分のものを残す</translation>
    </message>
</context>
<context>
    <name>handmap::DrawingLayersPanel</name>
    <message>
        <source>Buildings</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>目印</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>出発点</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>経路</translation>
    </message>
    <message>
        <source>Layers of the drawing</source>
        <translation>図面のレイヤー</translation>
    </message>
    <message>
        <source>Of the drawing</source>
        <translation>図面の要素</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>Opacity of the layer</source>
        <translation>レイヤーの不透明度</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Fade Layer</source>
        <translation>レイヤーの濃さを変更</translation>
    </message>
    <message>
        <source>Show or Hide Layer</source>
        <translation>レイヤーの表示を切り替え</translation>
    </message>
    <message>
        <source>Lock Layer</source>
        <translation>レイヤーをロック</translation>
    </message>
    <message>
        <source>While a run is shown: only where it is selected or drawn</source>
        <translation>実行を表示している間: 選択中または編集中だけ表示</translation>
    </message>
</context>
<context>
    <name>handmap::DrawingTool</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
</context>
<context>
    <name>handmap::DrawingWatch</name>
    <message>
        <source>Read the drawing as millimetres</source>
        <translation>図面をミリメートルとして読む</translation>
    </message>
    <message>
        <source>Read the drawing as centimetres</source>
        <translation>図面をセンチメートルとして読む</translation>
    </message>
    <message>
        <source>Mirror the drawing</source>
        <translation>図面を鏡像にする</translation>
    </message>
</context>
<context>
    <name>handmap::DriveStart</name>
    <message>
        <source>Where does the robot begin?</source>
        <translation>ロボットはどこから始めますか?</translation>
    </message>
    <message>
        <source>Its last drive ended %1 m from the start of the drawing.</source>
        <translation>前の走行は、図面の出発点から %1 m の所で終わりました。</translation>
    </message>
    <message>
        <source>Where it stopped</source>
        <translation>止まった所</translation>
    </message>
    <message>
        <source>At the start of the drawing</source>
        <translation>図面の出発点</translation>
    </message>
    <message>
        <source>When its last drive ended it was not known where it was.</source>
        <translation>前回の走行が終わったとき、ロボットの居場所は分かっていませんでした。</translation>
    </message>
    <message>
        <source>Place the start</source>
        <translation>出発点を置く</translation>
    </message>
</context>
<context>
    <name>handmap::EdgeRectangleTool</name>
    <message>
        <source>Drag or click along one wall of the building</source>
        <translation>建物の一つの壁に沿ってドラッグまたはクリックします</translation>
    </message>
    <message>
        <source>The other end of the wall · or type its length and angle</source>
        <translation>壁のもう一方の端 · または長さと角度を入力</translation>
    </message>
    <message>
        <source>How deep is it? Click, or type the depth · Backspace: one back · Esc: cancel</source>
        <translation>奥行きは? クリックするか数値を入力 · Backspace: 一つ戻る · Esc: 中止</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>奥行き</translation>
    </message>
</context>
<context>
    <name>handmap::EditActions</name>
    <message>
        <source>There is nothing on the clipboard to paste</source>
        <translation>貼り付けるものがクリップボードにありません</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>貼り付け</translation>
    </message>
    <message>
        <source>The clipboard holds no part of a drawing</source>
        <translation>クリップボードに図面の一部がありません</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>nothing has been changed</source>
        <translation>変更がありません</translation>
    </message>
    <message>
        <source>nothing has been taken back</source>
        <translation>取り消した変更がありません</translation>
    </message>
    <message>
        <source>nothing is selected</source>
        <translation>何も選択されていません</translation>
    </message>
    <message>
        <source>not one building or landmark is selected</source>
        <translation>建物または目印が一つだけ選択されていません</translation>
    </message>
    <message>
        <source>no building that is not locked, and no route, is selected</source>
        <translation>ロックされていない建物も経路も選択されていません</translation>
    </message>
    <message>
        <source>fewer than two buildings or landmarks are selected</source>
        <translation>選択された建物や目印が二つ未満です</translation>
    </message>
    <message>
        <source>fewer than three buildings or landmarks are selected</source>
        <translation>選択された建物や目印が三つ未満です</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>並べて複製</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Gap between columns</source>
        <translation>列の間隔</translation>
    </message>
    <message>
        <source>Gap between rows</source>
        <translation>行の間隔</translation>
    </message>
    <message>
        <source>what is selected is locked</source>
        <translation>選択したものはロックされています</translation>
    </message>
    <message>
        <source>“%1” changes nothing: what is selected is so already, or is locked.</source>
        <translation>「%1」で変わるものはありません。選んだものはすでにそうなっているか、ロックされています。</translation>
    </message>
    <message>
        <source>nothing is drawn yet</source>
        <translation>まだ何も描かれていません</translation>
    </message>
</context>
<context>
    <name>handmap::EditingPanels</name>
    <message>
        <source>Steps of editing</source>
        <translation>編集の履歴</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>開いたときの状態</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Issues (%1)</source>
        <translation>問題 (%1)</translation>
    </message>
</context>
<context>
    <name>handmap::EraserTool</name>
    <message>
        <source>Release to erase what is crossed out · Esc: cancel</source>
        <translation>離すと線を引いたものを消します · Esc: 中止</translation>
    </message>
    <message>
        <source>Drag over what shall go, or click it · what is locked stays</source>
        <translation>消すものの上をドラッグ、またはクリック · ロックしたものは残ります</translation>
    </message>
</context>
<context>
    <name>handmap::FileActions</name>
    <message>
        <source>Handmap drawings (*.handmap)</source>
        <translation>Handmap の図面 (*.handmap)</translation>
    </message>
    <message>
        <source>Open Re&amp;cent</source>
        <translation>最近使った図面(&amp;C)</translation>
    </message>
    <message>
        <source>Open a drawing</source>
        <translation>図面を開く</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>保存していない変更</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>「%1」の変更を保存しますか?</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>破棄(&amp;D)</translation>
    </message>
    <message>
        <source>Save the drawing</source>
        <translation>図面を保存</translation>
    </message>
    <message>
        <source>The corrected map</source>
        <translation>補正した地図</translation>
    </message>
    <message>
        <source>The drawing</source>
        <translation>図面</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Which map?</source>
        <translation>どの地図ですか?</translation>
    </message>
    <message>
        <source>%1 is in “%2”.</source>
        <translation>%1は「%2」に入りました。</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>フォルダーで表示</translation>
    </message>
    <message>
        <source>Say where</source>
        <translation>場所を指定</translation>
    </message>
    <message>
        <source>GeoJSON (*.geojson)</source>
        <translation>GeoJSON (*.geojson)</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>画像を書き出す</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>%1 belongs to the drawing.</source>
        <translation>%1 は図面が使っているファイルです。</translation>
    </message>
    <message>
        <source>Choose another name for what is exported.</source>
        <translation>書き出し先に別の名前を選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>%n building(s) of “%1” are a new drawing now, and where they lie on earth is kept.</source>
        <translation>
            <numerusform>「%1」の建物 %n 棟を新しい図面にしました。地球上の位置も保たれています。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n outline(s) were left out: they cross themselves or are too large.</source>
        <translation>
            <numerusform>%n 個の輪郭は、自分自身と交わるか大きすぎるため除きました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Drawings and public maps (*.handmap %1)</source>
        <translation>図面と公開地図 (*.handmap %1)</translation>
    </message>
    <message>
        <source>OpenStreetMap, GeoJSON and others (%1)</source>
        <translation>OpenStreetMap、GeoJSON など (%1)</translation>
    </message>
    <message>
        <source>Pictures (*.png);;Vector graphics (*.svg);;PDF (*.pdf)</source>
        <translation>画像 (*.png);;ベクター画像 (*.svg);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The plan</source>
        <translation>平面図</translation>
    </message>
    <message>
        <source>“%1” is being written…</source>
        <translation>「%1」を書いています…</translation>
    </message>
    <message>
        <source>OpenStreetMap (*.osm)</source>
        <translation>OpenStreetMap (*.osm)</translation>
    </message>
    <message>
        <source>KML (*.kml)</source>
        <translation>KML (*.kml)</translation>
    </message>
    <message>
        <source>GeoPackage (*.gpkg)</source>
        <translation>GeoPackage (*.gpkg)</translation>
    </message>
    <message>
        <source>DXF for CAD (*.dxf)</source>
        <translation>CAD 用 DXF (*.dxf)</translation>
    </message>
    <message>
        <source>Map of a robot, map_server (*.yaml)</source>
        <translation>ロボットの地図、map_server (*.yaml)</translation>
    </message>
    <message>
        <source>Export to other programs</source>
        <translation>ほかのプログラムに書き出す</translation>
    </message>
    <message>
        <source>A .%1 file tells where on earth the map lies.</source>
        <translation>.%1 のファイルは、地図が地球のどこにあるかを述べます。</translation>
    </message>
    <message>
        <source>The drawing does not say so yet: its georeference is the latitude and longitude of the origin. DXF and maps of robots need none.</source>
        <translation>図面にはまだそれがありません。位置情報は原点の緯度と経度です。DXF とロボットの地図には要りません。</translation>
    </message>
    <message>
        <source>Stop writing</source>
        <translation>書き出しをやめる</translation>
    </message>
    <message>
        <source>Stop writing?</source>
        <translation>書き出しをやめますか？</translation>
    </message>
    <message>
        <source>“%1” is not written to its end yet.</source>
        <translation>「%1」はまだ最後まで書き出されていません。</translation>
    </message>
    <message>
        <source>&amp;Stop writing</source>
        <translation>やめる(&amp;S)</translation>
    </message>
    <message>
        <source>Building of Open-RMF, for fleets (*.building.yaml)</source>
        <translation>Open-RMF の建物、ロボット群向け (*.building.yaml)</translation>
    </message>
    <message>
        <source>Reference coordinates of the robot&apos;s map, for fleets (*.fleet.yaml)</source>
        <translation>ロボットの地図の基準座標、ロボット群向け (*.fleet.yaml)</translation>
    </message>
    <message>
        <source>%1 (in cells of %2 m, it is a large place)</source>
        <translation>%1（広い場所のためセルは %2 m）</translation>
    </message>
</context>
<context>
    <name>handmap::FreehandTool</name>
    <message>
        <source>Enter: take it as %1 · Tab: something else · Esc: leave it as drawn</source>
        <translation>Enter: %1とする · Tab: 別の形 · Esc: 描いたまま残す</translation>
    </message>
    <message>
        <source>Draw once around the building</source>
        <translation>建物の周りを一筆で描きます</translation>
    </message>
    <message>
        <source>Draw around a building in one stroke</source>
        <translation>建物の周りを一筆で描きます</translation>
    </message>
    <message>
        <source>Straighten to %1</source>
        <translation>%1に整える</translation>
    </message>
</context>
<context>
    <name>handmap::GeoPinTool</name>
    <message>
        <source>Click a place whose latitude and longitude you know</source>
        <translation>緯度と経度を知っている場所をクリックします</translation>
    </message>
    <message>
        <source>Click a second place, far from the first one · Backspace takes the first back</source>
        <translation>一つ目から離れた二つ目の場所をクリックします · Backspace で一つ目を取り消し</translation>
    </message>
    <message>
        <source>%1°, %2°</source>
        <translation>%1°、%2°</translation>
    </message>
</context>
<context>
    <name>handmap::GeoreferenceActions</name>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Where is this place?</source>
        <translation>この場所はどこですか？</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>緯度</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>経度</translation>
    </message>
    <message>
        <source>These two places do not say where the drawing lies.</source>
        <translation>この二つの場所からは図面の位置が決まりません。</translation>
    </message>
    <message>
        <source>On earth the two places are %1 times as far apart as on the drawing.</source>
        <translation>この二つの場所は、地球上では図面の %1 倍離れています。</translation>
    </message>
    <message>
        <source>The drawing is georeferenced: its origin lies at %1°, %2°.</source>
        <translation>図面の地理座標を決めました。原点は %1°、%2° にあります。</translation>
    </message>
</context>
<context>
    <name>handmap::GuideWindow</name>
    <message>
        <source>The guide</source>
        <translation>手引き</translation>
    </message>
    <message>
        <source>A page of the guide</source>
        <translation>手引きのページ</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>手引きの中を探す</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>進む</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目次</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The folder of the guide in this language, under resources/guide.</extracomment>
        <translation>ja</translation>
    </message>
</context>
<context>
    <name>handmap::ImportDialog</name>
    <message>
        <source>Import a log</source>
        <translation>ログの取り込み</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>取り込む…</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Headings</source>
        <translation>方位</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Scans a second</source>
        <translation>一秒あたりのスキャン</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>As they look</source>
        <translation>数から判断</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>ミリ秒</translation>
    </message>
    <message>
        <source>microseconds</source>
        <translation>マイクロ秒</translation>
    </message>
    <message>
        <source>nanoseconds</source>
        <translation>ナノ秒</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>ラジアン</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>first:step, e.g. -90:0.5</source>
        <translation>最初:刻み、例 -90:0.5</translation>
    </message>
    <message>
        <source>Of the ranges of a scan: degrees, 0 ahead, positive to the left.</source>
        <translation>スキャンの距離の向き: 度、前が 0、左が正。</translation>
    </message>
    <message>
        <source>where there are no times</source>
        <translation>時刻がないとき</translation>
    </message>
    <message>
        <source>e.g. time=1,ranges=2-362</source>
        <translation>例 time=1,ranges=2-362</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>読んでいます…</translation>
    </message>
    <message>
        <source>There is no scan in it.</source>
        <translation>スキャンがありません。</translation>
    </message>
    <message>
        <source>Poses alone are no recording.</source>
        <translation>姿勢だけでは記録になりません。</translation>
    </message>
    <message numerus="yes">
        <source>%n scan(s)</source>
        <translation>
            <numerusform>スキャン %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pose(s)</source>
        <translation>
            <numerusform>姿勢 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Another File…</source>
        <translation>別のファイル(&amp;A)…</translation>
    </message>
    <message>
        <source>Such as the poses that belong to the scans.</source>
        <translation>スキャンに対応する姿勢など。</translation>
    </message>
    <message>
        <source>Place of the sensor</source>
        <translation>センサーの位置</translation>
    </message>
    <message>
        <source>x,y,z, e.g. 0.3,0,1.7</source>
        <translation>x,y,z、例: 0.3,0,1.7</translation>
    </message>
    <message>
        <source>Where on the robot the scanner is: ahead, left, up, metres, and how far it is turned to the left, degrees.</source>
        <translation>スキャナーがロボットのどこにあるか: 前、左、上（メートル）、左への向き（度）。</translation>
    </message>
</context>
<context>
    <name>handmap::IssuesPanel</name>
    <message>
        <source>Issues of the drawing</source>
        <translation>図面の問題</translation>
    </message>
    <message>
        <source>Nothing to mend.</source>
        <translation>直すものはありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n issue(s); a click shows where.</source>
        <translation>
            <numerusform>問題 %n 件。クリックすると場所が表示されます。</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no building yet.</source>
        <translation>建物がまだありません。</translation>
    </message>
    <message>
        <source>There is no start yet: a run needs to know where the robot begins.</source>
        <translation>出発点がまだありません。実行にはロボットの出発点が必要です。</translation>
    </message>
    <message>
        <source>The start lies in %1.</source>
        <translation>出発点が %1 の中にあります。</translation>
    </message>
    <message>
        <source>The route leads through %1.</source>
        <translation>経路が %1 を通り抜けています。</translation>
    </message>
    <message>
        <source>The route begins %1 m from the start.</source>
        <translation>経路の始まりが出発点から %1 m 離れています。</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3 m².</source>
        <translation>%1 と %2 が %3 m² 重なっています。</translation>
    </message>
    <message>
        <source>The outline of %1 crosses itself.</source>
        <translation>%1 の輪郭が自分自身と交差しています。</translation>
    </message>
    <message>
        <source>%1 and %2 have the same name.</source>
        <translation>%1 と %2 の名前が同じです。</translation>
    </message>
    <message>
        <source>%1 is only %2 m wide.</source>
        <translation>%1 の幅が %2 m しかありません。</translation>
    </message>
</context>
<context>
    <name>handmap::KeysPanel</name>
    <message>
        <source>Reset</source>
        <translation>標準に戻す</translation>
    </message>
    <message>
        <source>Reset All</source>
        <translation>すべて標準に戻す</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>こちらに割り当てる</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>コマンドとキー</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>働き</translation>
    </message>
    <message>
        <source>Find a command or key</source>
        <translation>コマンドまたはキーを検索</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>新しいキー</translation>
    </message>
    <message>
        <source>Keys:</source>
        <translation>キー:</translation>
    </message>
    <message>
        <source>“%1” already means “%2”.</source>
        <translation>「%1」はすでに「%2」に使われています。</translation>
    </message>
</context>
<context>
    <name>handmap::LandmarkPage</name>
    <message>
        <source>Landmark</source>
        <translation>目印</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name Landmark</source>
        <translation>目印に名前を付ける</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>Change x</source>
        <translation>x を変更</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Change y</source>
        <translation>y を変更</translation>
    </message>
</context>
<context>
    <name>handmap::LandmarkTool</name>
    <message>
        <source>Click to mark a place, then type its name</source>
        <translation>クリックで目印を付け、続けて名前を入力します</translation>
    </message>
</context>
<context>
    <name>handmap::Language</name>
    <message>
        <source>Start again</source>
        <translation>起動し直す</translation>
    </message>
    <message>
        <source>The other language comes with the next start of the program.</source>
        <translation>次に起動したときから、選んだ言語になります。</translation>
    </message>
</context>
<context>
    <name>handmap::LayersPanel</name>
    <message>
        <source>Drawing</source>
        <translation>図面</translation>
    </message>
    <message>
        <source>The map as it is drawn</source>
        <translation>描いたままの地図</translation>
    </message>
    <message>
        <source>Corrected map</source>
        <translation>補正した地図</translation>
    </message>
    <message>
        <source>Where walls may be</source>
        <translation>壁のありうる範囲</translation>
    </message>
    <message>
        <source>How sure each corrected wall is: two times of three it is within its band</source>
        <translation>補正した壁の確かさ。三回に二回は帯の中にあります</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>Where the robot may be; the surer, the stronger</source>
        <translation>ロボットがいるかもしれない場所。確かなほど濃い</translation>
    </message>
    <message>
        <source>Swarms</source>
        <translation>群れ</translation>
    </message>
    <message>
        <source>What the buildings in sight may be: one outline a sample</source>
        <translation>見えている建物の候補: 標本ごとに一つの輪郭</translation>
    </message>
    <message>
        <source>Way of the robot</source>
        <translation>ロボットの軌跡</translation>
    </message>
    <message>
        <source>Its way as the run has corrected it</source>
        <translation>実行が補正した軌跡</translation>
    </message>
    <message>
        <source>Odometry alone</source>
        <translation>オドメトリのみ</translation>
    </message>
    <message>
        <source>Its way as it measures its own motion, without the drawing</source>
        <translation>図面を使わず、ロボットが測った動きだけによる軌跡</translation>
    </message>
    <message>
        <source>Local map</source>
        <translation>局所地図</translation>
    </message>
    <message>
        <source>The walls that the robot sees around itself</source>
        <translation>ロボットの周りに見える壁</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>真値</translation>
    </message>
    <message>
        <source>Where the recording knows the true way; never used by the run</source>
        <translation>記録が知っている真の軌跡。実行には使いません</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Pictures below the drawing</source>
        <translation>図面の下の画像</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>The metric grid</source>
        <translation>メートル格子</translation>
    </message>
    <message>
        <source>The best map of the run. Dashed: a wall that nobody saw. Hatched: a doubtful building</source>
        <translation>実行で最良の地図。破線: 誰も見ていない壁。斜線: 疑わしい建物</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>From the drawn to the corrected place, and how far that is</source>
        <translation>描いた場所から補正した場所への矢印と距離</translation>
    </message>
    <message>
        <source>Where the robot may be</source>
        <translation>ロボットのありうる範囲</translation>
    </message>
    <message>
        <source>How sure its place and its direction are: one standard deviation of each</source>
        <translation>位置と向きの確かさ。それぞれ標準偏差一つ分</translation>
    </message>
    <message>
        <source>Rays of a wall</source>
        <translation>壁への光線</translation>
    </message>
    <message>
        <source>What placed the wall that is asked about</source>
        <translation>調べている壁の位置を決めたもの</translation>
    </message>
    <message>
        <source>A wall that nobody saw</source>
        <translation>誰も見ていない壁</translation>
    </message>
    <message>
        <source>A doubtful building: point at it to read why</source>
        <translation>疑わしい建物: ポインターを合わせると理由が読めます</translation>
    </message>
    <message>
        <source>%1: how strongly it is drawn</source>
        <translation>%1: 表示の濃さ</translation>
    </message>
    <message>
        <source>How strongly it is drawn</source>
        <translation>表示の濃さ</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>What the sensor sees now: strong where that is surely a wall</source>
        <translation>センサーが今見ているもの。壁として確かなほど濃く描きます</translation>
    </message>
    <message>
        <source>Visible walls</source>
        <translation>見えている壁</translation>
    </message>
    <message>
        <source>The parts of the corrected walls that the robot sees now</source>
        <translation>補正した壁のうち、ロボットが今見ている部分</translation>
    </message>
    <message>
        <source>Visibility range</source>
        <translation>視界の範囲</translation>
    </message>
    <message>
        <source>How far the sensor reaches, and what it looks through now</source>
        <translation>センサーの届く範囲と、今見通しているところ</translation>
    </message>
</context>
<context>
    <name>handmap::LivePanel</name>
    <message>
        <source>Wheels</source>
        <translation>車輪</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>スキャナー</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>雲台</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Not used: </source>
        <translation>使われなかったもの: </translation>
    </message>
    <message>
        <source>The recording has ended, the run goes on: %1</source>
        <translation>記録は終わりましたが、実行は続きます: %1</translation>
    </message>
    <message>
        <source>Recorded: %1 in %2</source>
        <translation>記録済み: %1、保存先 %2</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>見回す</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>頻度</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>Stop the robot; its head then looks into all directions</source>
        <translation>ロボットを止めてください。雲台が全方向を見回します</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 observations taken, %2 passed over for newer ones</source>
        <translation>観測 %1 件を使用、%2 件はより新しいもののため省略</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>閉じています</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>接続中</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>degraded</source>
        <translation>不調</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>To ROS</source>
        <translation>ROS へ</translation>
    </message>
    <message>
        <source>To Foxglove</source>
        <translation>Foxglove へ</translation>
    </message>
</context>
<context>
    <name>handmap::LiveWatch</name>
    <message>
        <source>Nothing has been observed for %1 s: the robot is shown by its odometry alone.</source>
        <translation>%1 秒間何も観測されていません: ロボットはオドメトリだけで示されています。</translation>
    </message>
    <message>
        <source>It is no longer known where the robot is.</source>
        <translation>ロボットの居場所が分からなくなりました。</translation>
    </message>
    <message>
        <source>If you see it, say so with “Robot is here”.</source>
        <translation>見えているなら「ロボットはここ」で教えてください。</translation>
    </message>
    <message>
        <source>The recording has ended, the drive goes on.</source>
        <translation>記録は終わりました。走行は続きます。</translation>
    </message>
    <message numerus="yes">
        <source>The program ended in the middle of a drive. Its recording is whole, up to its last observation: %n of them.</source>
        <translation>
            <numerusform>プログラムが走行の途中で終わりました。その記録は最後の観測まで完全です: %n 個。</numerusform>
        </translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>It is known again where the robot is.</source>
        <translation>ロボットの居場所がまた分かりました。</translation>
    </message>
    <message>
        <source>Nothing has been observed for %1 s, and nothing tells where the robot drives.</source>
        <translation>%1 秒間何も観測されておらず、ロボットの動きも分かりません。</translation>
    </message>
    <message>
        <source>Nothing has been observed yet, after %1 s.</source>
        <translation>%1 秒たっても、まだ何も観測されていません。</translation>
    </message>
    <message>
        <source>The robot is not where the drive is said to begin: it sees something else than it saw there before.</source>
        <translation>ロボットは、走行を始めるとされた場所にいません。以前そこで見たものと違うものが見えています。</translation>
    </message>
</context>
<context>
    <name>handmap::LogKeeper</name>
    <message>
        <source>Frame %1 was skipped: %2</source>
        <translation>フレーム %1 を飛ばしました: %2</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message numerus="yes">
        <source>The run begins: %1, %n building(s) drawn</source>
        <translation>
            <numerusform>実行開始: %1、描いた建物 %n 棟</numerusform>
        </translation>
    </message>
    <message>
        <source>No odometry: the robot is taken to go on as before</source>
        <translation>オドメトリがありません。ロボットは直前の動きを続けるとみなします</translation>
    </message>
    <message>
        <source>The odometry is back</source>
        <translation>オドメトリが戻りました</translation>
    </message>
    <message>
        <source>The run was stopped</source>
        <translation>実行は停止されました</translation>
    </message>
    <message>
        <source>The run is done</source>
        <translation>実行が終わりました</translation>
    </message>
    <message numerus="yes">
        <source>A loop was closed; %n so far</source>
        <translation>
            <numerusform>ループが閉じました (これまで %n 回)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::LogModel</name>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>時刻 (秒)</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>出来事</translation>
    </message>
</context>
<context>
    <name>handmap::LogPanel</name>
    <message>
        <source>Filter</source>
        <translation>絞り込み</translation>
    </message>
    <message>
        <source>Words that the log is filtered by</source>
        <translation>ログを絞り込む語</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Warnings and problems</source>
        <translation>警告と問題</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>What the log shows</source>
        <translation>ログに示すもの</translation>
    </message>
    <message>
        <source>Log of the run</source>
        <translation>実行のログ</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
</context>
<context>
    <name>handmap::MainWindow</name>
    <message>
        <source>Main</source>
        <translation>メイン</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Transport</source>
        <translation>実行操作</translation>
    </message>
    <message>
        <source>Running, 000 of 000</source>
        <translation>実行中、000 / 000</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m</source>
        <translation>x %1 m、y %2 m</translation>
    </message>
    <message>
        <source>%1 px/m</source>
        <translation>%1 px/m</translation>
    </message>
    <message>
        <source>Handmap %1</source>
        <translation>Handmap %1</translation>
    </message>
    <message>
        <source>Draw the map you remember; Handmap finds the robot on it and corrects the drawing. Free software: GPL-3.0-or-later, without any warranty.</source>
        <translation>覚えている地図を描くと、Handmap がその上でロボットの位置を見つけ、図面を補正します。自由ソフトウェア (GPL-3.0 以降)、無保証です。</translation>
    </message>
    <message>
        <source>Unsaved work would be lost in a crash: %1</source>
        <translation>異常終了すると保存していない作業が失われます: %1</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Unsaved work is kept in %1</source>
        <translation>保存していない作業は %1 に置かれています</translation>
    </message>
    <message>
        <source>“%1” is not possible now: %2.</source>
        <translation>「%1」は今はできません：%2。</translation>
    </message>
    <message>
        <source>Teach buildings</source>
        <translation>建物を教える</translation>
    </message>
</context>
<context>
    <name>handmap::MapCanvas</name>
    <message>
        <source>Drawing</source>
        <translation>図面</translation>
    </message>
</context>
<context>
    <name>handmap::MapDocument</name>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>Save Model with the Map</source>
        <translation>モデルを地図とともに保存</translation>
    </message>
    <message>
        <source>Add Building %1</source>
        <translation>建物 %1 を追加</translation>
    </message>
    <message>
        <source>Add Landmark %1</source>
        <translation>目印 %1 を追加</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 の名前を変更</translation>
    </message>
    <message>
        <source>%1 Objects</source>
        <translation>%1 個のオブジェクト</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 を削除</translation>
    </message>
    <message>
        <source>Set Start</source>
        <translation>出発点を設定</translation>
    </message>
    <message>
        <source>Change Route</source>
        <translation>経路を変更</translation>
    </message>
    <message>
        <source>Name Map</source>
        <translation>地図に名前を付ける</translation>
    </message>
    <message>
        <source>Change Uncertainty</source>
        <translation>不確かさを変更</translation>
    </message>
    <message>
        <source>Add Picture %1</source>
        <translation>画像 %1 を追加</translation>
    </message>
    <message>
        <source>Georeference</source>
        <translation>地理座標</translation>
    </message>
    <message>
        <source>Accept Correction</source>
        <translation>補正を取り込む</translation>
    </message>
</context>
<context>
    <name>handmap::MapModel</name>
    <message>
        <source>The model of this drawing cannot be used: %1</source>
        <translation>この図面のモデルは使えません: %1</translation>
    </message>
    <message>
        <source>Runs take the program&apos;s own until you load or teach another.</source>
        <translation>別のモデルを読み込むか教えるまで、実行にはプログラム付属のものを使います。</translation>
    </message>
    <message>
        <source>Untrained painting</source>
        <translation>学習していない塗り</translation>
    </message>
    <message>
        <source>What was painted in “Teach buildings” is in no model yet. Leave it?</source>
        <translation>「建物を教える」で塗ったものは、まだどのモデルにも入っていません。このまま終えますか?</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>とどまる(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Leave</source>
        <translation>終える(&amp;L)</translation>
    </message>
    <message>
        <source>Unsaved model</source>
        <translation>保存していないモデル</translation>
    </message>
    <message>
        <source>The model that was taught in “Teach buildings” is in no file.</source>
        <translation>「建物を教える」で作ったモデルは、まだファイルに保存されていません。</translation>
    </message>
    <message>
        <source>&amp;Save model…</source>
        <translation>モデルを保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>破棄(&amp;D)</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>モデルを保存</translation>
    </message>
    <message>
        <source>Models (*.json)</source>
        <translation>モデル (*.json)</translation>
    </message>
    <message>
        <source>The model is saved with “%1”.</source>
        <translation>モデルは「%1」とともに保存されました。</translation>
    </message>
    <message>
        <source>Whoever opens the drawing gets it too; keep both files together.</source>
        <translation>図面を開く人にも使われます。二つのファイルは一緒に置いてください。</translation>
    </message>
</context>
<context>
    <name>handmap::MapPage</name>
    <message>
        <source>Map</source>
        <translation>地図</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>描いた確かさ</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Position ±</source>
        <translation>位置 ±</translation>
    </message>
    <message>
        <source>How far buildings may lie from where they are drawn</source>
        <translation>建物が描いた場所からどれだけ離れている可能性があるか</translation>
    </message>
    <message>
        <source>Size ±</source>
        <translation>大きさ ±</translation>
    </message>
    <message>
        <source>How wrong their widths and depths may be</source>
        <translation>幅と奥行きがどれだけ違っている可能性があるか</translation>
    </message>
    <message>
        <source>Scale and turn are known</source>
        <translation>縮尺と向きは正しい</translation>
    </message>
    <message>
        <source>Drawn over an aerial picture or from a public map</source>
        <translation>航空写真の上に、または公開地図から描いたもの</translation>
    </message>
    <message>
        <source>Scale ±</source>
        <translation>縮尺 ±</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much too large or too small all of it may be; 0: to scale</source>
        <translation>全体がどれだけ大きすぎる、または小さすぎる可能性があるか。0: 縮尺どおり</translation>
    </message>
    <message>
        <source>Turn ±</source>
        <translation>向き ±</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How far all of it may be turned; 0: true</source>
        <translation>全体がどれだけ回っている可能性があるか。0: 正しい</translation>
    </message>
    <message>
        <source>Georeferenced (WGS 84)</source>
        <translation>地理座標あり (WGS 84)</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>緯度</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>経度</translation>
    </message>
    <message>
        <source>x axis from east</source>
        <translation>東から x 軸への角度</translation>
    </message>
    <message>
        <source>Buildings: %1</source>
        <translation>建物: %1</translation>
    </message>
    <message>
        <source>
No start yet: a run needs to know where the robot begins.</source>
        <translation>
出発点がまだありません。実行にはロボットの出発点が必要です。</translation>
    </message>
    <message>
        <source>
Corrected by a run.</source>
        <translation>
実行により補正済み。</translation>
    </message>
    <message>
        <source>Together ±</source>
        <translation>全体 ±</translation>
    </message>
    <message>
        <source>How far all buildings may lie off together: a displaced aerial picture</source>
        <translation>すべての建物がそろってずれていそうな距離。航空写真のずれなど</translation>
    </message>
</context>
<context>
    <name>handmap::MeasureTool</name>
    <message>
        <source>Click from point to point to measure · Esc: leave</source>
        <translation>点から点へクリックして測ります · Esc: 終了</translation>
    </message>
    <message>
        <source>The next point · Enter or a double click: done · Backspace: one back</source>
        <translation>次の点 · Enter またはダブルクリック: 完了 · Backspace: 一つ戻る</translation>
    </message>
    <message>
        <source>in all %1</source>
        <translation>合計 %1</translation>
    </message>
    <message>
        <source>   %1 m²</source>
        <translation>   %1 m²</translation>
    </message>
</context>
<context>
    <name>handmap::Message</name>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じる</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2 回)</translation>
    </message>
</context>
<context>
    <name>handmap::MessageBar</name>
    <message>
        <source>Only the newest</source>
        <translation>最新のものだけ</translation>
    </message>
    <message numerus="yes">
        <source>%n earlier message(s)</source>
        <translation>
            <numerusform>前のメッセージ %n 件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>handmap::NameEditor</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name %1</source>
        <translation>%1 に名前を付ける</translation>
    </message>
    <message>
        <source>Name: Enter</source>
        <translation>名前：Enter</translation>
    </message>
</context>
<context>
    <name>handmap::NumberField</name>
    <message>
        <source>several</source>
        <translation>複数</translation>
    </message>
</context>
<context>
    <name>handmap::ObjectTreeModel</name>
    <message>
        <source>Start</source>
        <translation>出発点</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>経路</translation>
    </message>
    <message>
        <source>Buildings (%1)</source>
        <translation>建物 (%1)</translation>
    </message>
    <message>
        <source>Landmarks (%1)</source>
        <translation>目印 (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>Building %1</source>
        <translation>建物 %1</translation>
    </message>
    <message>
        <source>Landmark %1</source>
        <translation>目印 %1</translation>
    </message>
    <message>
        <source>Picture %1</source>
        <translation>画像 %1</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>非表示</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック中</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>ロックなし</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>What is hidden still belongs to the drawing</source>
        <translation>隠したものも図面の一部です</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>Name %1</source>
        <translation>%1 に名前を付ける</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>%1 をロック</translation>
    </message>
    <message>
        <source>Show or Hide %1</source>
        <translation>%1 の表示を切り替え</translation>
    </message>
    <message>
        <source>What is locked is not moved, resized or deleted by hand; whether a run may move a building is set in its properties</source>
        <translation>ロックされたものは手では動かず、大きさも変わらず、消えません。実行が建物を動かしてよいかはプロパティで決めます</translation>
    </message>
</context>
<context>
    <name>handmap::ObjectsPanel</name>
    <message>
        <source>Objects of the drawing</source>
        <translation>図面のオブジェクト</translation>
    </message>
    <message>
        <source>Find by id or name</source>
        <translation>ID または名前で検索</translation>
    </message>
</context>
<context>
    <name>handmap::PaperActions</name>
    <message>
        <source>Open a photo of a drawing</source>
        <translation>図の写真を開く</translation>
    </message>
    <message>
        <source>Photos (*.png *.jpg *.jpeg)</source>
        <translation>写真 (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Reading the drawing on “%1”…</source>
        <translation>「%1」の図を読んでいます…</translation>
    </message>
    <message>
        <source>“%1” has no closed shapes.</source>
        <translation>「%1」に閉じた形がありません。</translation>
    </message>
    <message>
        <source>Draw each building as a closed outline, with a pen, and take the photo from above.</source>
        <translation>建物を一つずつペンで閉じた輪郭に描き、上から写真を撮ってください。</translation>
    </message>
    <message numerus="yes">
        <source>%n closed shape(s) are found.</source>
        <translation>
            <numerusform>閉じた形が %n 個見つかりました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Click those that are no buildings, then press Enter.</source>
        <translation>建物でないものをクリックし、Enter を押してください。</translation>
    </message>
    <message>
        <source>Another drawing is printed on this sheet, or this one has changed.</source>
        <translation>この用紙には別の図面が印刷されているか、図面が変わっています。</translation>
    </message>
    <message>
        <source>Say how wide it is instead.</source>
        <translation>代わりに幅を示してください。</translation>
    </message>
    <message>
        <source>How large is it?</source>
        <translation>大きさは？</translation>
    </message>
    <message>
        <source>From the leftmost building to the rightmost</source>
        <translation>左端の建物から右端の建物まで</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Take Over from Paper</source>
        <translation>紙から取り込む</translation>
    </message>
    <message numerus="yes">
        <source>%n building(s) are taken over; the page lies under the drawing.</source>
        <translation>
            <numerusform>建物を %n 棟取り込みました。紙は図面の下にあります。</numerusform>
        </translation>
    </message>
    <message>
        <source>Say with the start tool (T) where the robot begins.</source>
        <translation>出発点の道具（T）でロボットの始まる所を示してください。</translation>
    </message>
    <message>
        <source>Print a sheet to draw on</source>
        <translation>描くための用紙を印刷</translation>
    </message>
    <message>
        <source>What is to be on the sheet?</source>
        <translation>用紙に何を印刷しますか？</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>The drawing</source>
        <translation>図面</translation>
    </message>
    <message>
        <source>Width of the place</source>
        <translation>場所の幅</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The sheet</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>The drawing alone, over the used sheet</source>
        <translation>図面だけ（使った用紙に重ねる）</translation>
    </message>
    <message>
        <source>Something lies over the sheet: what it hides is not ticked.</source>
        <translation>用紙の上に何かあります。隠れた部分にはチェックを付けていません。</translation>
    </message>
    <message>
        <source>Open camera</source>
        <translation>カメラを開く</translation>
    </message>
    <message>
        <source>Device, address or video</source>
        <translation>デバイス、アドレス、または動画</translation>
    </message>
    <message>
        <source>Looking through “%1”…</source>
        <translation>「%1」を見ています…</translation>
    </message>
    <message>
        <source>No printed sheet is seen.</source>
        <translation>印刷した用紙が見えません。</translation>
    </message>
    <message>
        <source>All four marks must be in the picture, and nothing over them.</source>
        <translation>四つの目印がすべて画面に入り、隠れていないようにしてください。</translation>
    </message>
    <message>
        <source>What is drawn on the sheet is followed.</source>
        <translation>用紙に描いたものを追っています。</translation>
    </message>
    <message>
        <source>Enter takes what is ticked and closes the camera, Esc takes nothing.</source>
        <translation>Enter でチェックしたものを取り込んでカメラを閉じます。Esc なら何も取り込みません。</translation>
    </message>
    <message>
        <source>Something lies over the sheet.</source>
        <translation>用紙の上に何かあります。</translation>
    </message>
    <message>
        <source>Close the camera</source>
        <translation>カメラを閉じる</translation>
    </message>
    <message>
        <source>The code on the sheet cannot be read: it lies where the drawing is printed now.</source>
        <translation>用紙の符号が読めません。いまの図面を印刷したときの位置に置きました。</translation>
    </message>
    <message>
        <source>The page is kept beside the drawing. Save the drawing where there is room, then press Enter again.</source>
        <translation>紙の画像は図面の横に保存されます。書き込める場所に図面を保存してから、もう一度 Enter を押してください。</translation>
    </message>
</context>
<context>
    <name>handmap::PaperTool</name>
    <message>
        <source>Choose “From Paper…” to open a photo of a drawing</source>
        <translation>「紙から…」で図の写真を開いてください</translation>
    </message>
    <message numerus="yes">
        <source>Click a shape to take or leave it · Tab and Del do so by keys · Enter: take the %n ticked · Esc: none</source>
        <translation>
            <numerusform>形をクリックで取捨 · キーでは Tab と Del · Enter: 印の付いた %n 個を取り込む · Esc: 取り込まない</numerusform>
        </translation>
    </message>
    <message>
        <source>✓ changes one</source>
        <translation>✓ 既存を変更</translation>
    </message>
</context>
<context>
    <name>handmap::PhaseWords</name>
    <message>
        <source>Prediction</source>
        <translation>予測</translation>
    </message>
    <message>
        <source>Local map</source>
        <translation>局所地図</translation>
    </message>
    <message>
        <source>Swarms %1/%2</source>
        <translation>群れ %1/%2</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>重み</translation>
    </message>
    <message>
        <source>Resampling</source>
        <translation>リサンプリング</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>道のり</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>Signs of walls</source>
        <translation>壁の兆候</translation>
    </message>
    <message>
        <source>Buildings found</source>
        <translation>見つかった建物</translation>
    </message>
    <message>
        <source>Matching</source>
        <translation>対応付け</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>補正</translation>
    </message>
    <message>
        <source>The particles go on by the odometry and its noise; the best one moved by %1 m and turned by %2°.</source>
        <translation>粒子はオドメトリとその雑音に従って進みます。最良の粒子は %1 m 動き、%2° 回りました。</translation>
    </message>
    <message>
        <source>The walls seen over the last metres, laid at the best particle.</source>
        <translation>直近の数メートルで見えた壁を、最良の粒子の位置に置いたもの。</translation>
    </message>
    <message numerus="yes">
        <source>Samples of %n building(s) in sight, before they move; score %1.</source>
        <translation>
            <numerusform>視界にある建物 %n 棟の標本 (動く前)。得点 %1。</numerusform>
        </translation>
    </message>
    <message>
        <source>The best outlines moved by up to %1 m; score %2.</source>
        <translation>最良の輪郭は最大 %1 m 動きました。得点 %2。</translation>
    </message>
    <message>
        <source>Each particle weighs as what it sees fits its map: as good as %1 of %2 particles.</source>
        <translation>各粒子の重みは、見えたものがその地図にどれだけ合うかで決まります。%2 個のうち %1 個分に相当します。</translation>
    </message>
    <message>
        <source>Not due: enough particles count. All %1 stay.</source>
        <translation>不要です。十分な数の粒子が効いています。%1 個すべて残ります。</translation>
    </message>
    <message>
        <source>%1 of %2 particles stay, the heavy ones more than once.</source>
        <translation>%2 個のうち %1 個の粒子が残り、重いものは複数になります。</translation>
    </message>
    <message>
        <source>The robot drove %1 m and turned %2°, by odometry or matched scans.</source>
        <translation>オドメトリまたはスキャンの照合によると、ロボットは %1 m 進み、%2° 回りました。</translation>
    </message>
    <message>
        <source>The last poses and buildings fitted together: the robot moved by %1 m and turned by %2°.</source>
        <translation>最近の姿勢と建物をまとめて合わせました。ロボットは %1 m 動き、%2° 回りました。</translation>
    </message>
    <message>
        <source>%1 walls and %2 buildings in sight, found without the drawing.</source>
        <translation>視界に壁 %1 本、建物 %2 棟。図面を使わずに見つけました。</translation>
    </message>
    <message>
        <source>%1 of %2 found buildings are matched with drawn ones (dotted lines).</source>
        <translation>見つかった建物 %2 棟のうち %1 棟が図面の建物に対応付けられました (点線)。</translation>
    </message>
    <message>
        <source>No building of the map moved.</source>
        <translation>地図の建物は動きませんでした。</translation>
    </message>
    <message numerus="yes">
        <source>%n building(s) of the map moved by up to %1 m.</source>
        <translation>
            <numerusform>地図の建物 %n 棟が最大 %1 m 動きました。</numerusform>
        </translation>
    </message>
    <message>
        <source>A loop was closed. %1</source>
        <translation>ループが閉じました。%1</translation>
    </message>
    <message>
        <source>Where walls are likely by the last frames: the stronger, the likelier.</source>
        <translation>最近のフレームから壁がありそうなところ。濃いほど確かです。</translation>
    </message>
</context>
<context>
    <name>handmap::PictureActions</name>
    <message>
        <source>Add a picture underneath</source>
        <translation>下に敷く画像を追加</translation>
    </message>
    <message>
        <source>There are %1 pictures, and no room for more.</source>
        <translation>画像は %1 枚あり、これ以上は追加できません。</translation>
    </message>
    <message>
        <source>The map has taken over where on Earth it lies.</source>
        <translation>地図に画像の地理座標を取り込みました。</translation>
    </message>
    <message>
        <source>What is drawn already may have to be moved over it.</source>
        <translation>すでに描いたものは、画像に合わせて動かす必要があるかもしれません。</translation>
    </message>
    <message>
        <source>Its pixels are not square: it is off by up to %1 m.</source>
        <translation>画素が正方形ではありません。最大 %1 m ずれます。</translation>
    </message>
    <message>
        <source>“%1” lies where its file says.</source>
        <translation>「%1」をファイルの示す場所に置きました。</translation>
    </message>
    <message>
        <source>It lies too far from where the map is; drag it to its place.</source>
        <translation>地図の場所から遠すぎます。正しい場所へドラッグしてください。</translation>
    </message>
    <message>
        <source>Drag it to its place. Its scale is a guess:</source>
        <translation>正しい場所へドラッグしてください。縮尺は仮のものです:</translation>
    </message>
    <message>
        <source>“%1” lies under the drawing.</source>
        <translation>「%1」を図面の下に敷きました。</translation>
    </message>
    <message>
        <source>Scale by a length</source>
        <translation>長さで縮尺を合わせる</translation>
    </message>
    <message>
        <source>Fit by points</source>
        <translation>点で合わせる</translation>
    </message>
    <message>
        <source>Pictures and maps of robots (%1 %2)</source>
        <translation>画像とロボットの地図 (%1 %2)</translation>
    </message>
    <message>
        <source>Maps of robots, map_server (%1)</source>
        <translation>ロボットの地図、map_server (%1)</translation>
    </message>
</context>
<context>
    <name>handmap::PicturePage</name>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Move Picture</source>
        <translation>画像を移動</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>縮尺</translation>
    </message>
    <message>
        <source> m/px</source>
        <translation> m/px</translation>
    </message>
    <message>
        <source>Scale Picture</source>
        <translation>画像の縮尺を変更</translation>
    </message>
    <message>
        <source>Turn Picture</source>
        <translation>画像を回転</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Fade Picture</source>
        <translation>画像の濃さを変更</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>非表示</translation>
    </message>
    <message>
        <source>Hide Picture</source>
        <translation>画像を隠す</translation>
    </message>
    <message>
        <source>Locked: stays where it is</source>
        <translation>ロック: 動かさない</translation>
    </message>
    <message>
        <source>Lock Picture</source>
        <translation>画像をロック</translation>
    </message>
    <message>
        <source>Scale by a length</source>
        <translation>長さで縮尺を合わせる</translation>
    </message>
    <message>
        <source>Click two points whose distance you know, then say how far it is</source>
        <translation>距離のわかる二点をクリックし、その距離を入力します</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>The picture cannot be that large or small.</source>
        <translation>画像をその大きさにはできません。</translation>
    </message>
    <message>
        <source>Fit by points</source>
        <translation>点で合わせる</translation>
    </message>
    <message>
        <source>Click points of the picture and where they belong on the map</source>
        <translation>画像の点と、地図上の対応する場所をクリックします</translation>
    </message>
    <message>
        <source>Fit now</source>
        <translation>合わせる</translation>
    </message>
    <message>
        <source>The pairs of points lie all at one place, or too far apart.</source>
        <translation>点の組がすべて同じ場所にあるか、離れすぎています。</translation>
    </message>
</context>
<context>
    <name>handmap::PictureTool</name>
    <message>
        <source>There is no picture yet: Draw / Add Picture Underneath…, or drop one here</source>
        <translation>画像がまだありません。「描画」→「下に敷く画像を追加…」を選ぶか、ここにドロップしてください</translation>
    </message>
    <message>
        <source>This picture is locked · Layers unlocks it</source>
        <translation>この画像はロックされています · 「レイヤー」で解除できます</translation>
    </message>
    <message>
        <source>Drag to move · corners scale, the round handle turns · arrow keys move, with Ctrl they turn and scale</source>
        <translation>ドラッグで移動 · 角で拡大縮小、丸いハンドルで回転 · 矢印キーで移動、Ctrl とともに回転と拡大縮小</translation>
    </message>
    <message>
        <source>Click two points whose distance you know</source>
        <translation>距離のわかる二点をクリックします</translation>
    </message>
    <message>
        <source>Type the distance in metres, then Enter · Esc: other points</source>
        <translation>距離をメートルで入力して Enter · Esc: 点を選び直す</translation>
    </message>
    <message>
        <source>Now click where this point belongs on the map</source>
        <translation>次に、この点に対応する地図上の場所をクリックします</translation>
    </message>
    <message>
        <source>Click a point in the picture, then where it belongs on the map</source>
        <translation>画像の点をクリックし、次に地図上の対応する場所をクリックします</translation>
    </message>
    <message>
        <source>Enter fits the picture · a third pair makes it surer · Backspace: one point back</source>
        <translation>Enter で画像を合わせます · 三組目でより確かになります · Backspace: 一点戻る</translation>
    </message>
    <message>
        <source>Turn Picture</source>
        <translation>画像を回転</translation>
    </message>
    <message>
        <source>Scale Picture</source>
        <translation>画像の縮尺を変更</translation>
    </message>
    <message>
        <source>Move Picture</source>
        <translation>画像を移動</translation>
    </message>
    <message>
        <source>Fit Picture</source>
        <translation>画像を合わせる</translation>
    </message>
    <message>
        <source>Adjust Picture</source>
        <translation>画像を調整</translation>
    </message>
</context>
<context>
    <name>handmap::PlaybackActions</name>
    <message>
        <source>Motion guessed at %1</source>
        <translation>%1 で動きを推測</translation>
    </message>
    <message>
        <source>The clock went back by %1 s</source>
        <translation>時計が %1 秒戻りました</translation>
    </message>
    <message>
        <source>Nothing came for %1 s</source>
        <translation>%1 秒間何も届きませんでした</translation>
    </message>
    <message>
        <source>Frame %1 was skipped: %2</source>
        <translation>フレーム %1 を飛ばしました: %2</translation>
    </message>
    <message>
        <source>You said where the robot was</source>
        <translation>ロボットの位置を指定しました</translation>
    </message>
    <message>
        <source>no run has seen anything yet</source>
        <translation>まだ何も観測していません</translation>
    </message>
    <message>
        <source>the first moment that is kept is shown</source>
        <translation>残っている最初の時点を表示しています</translation>
    </message>
    <message>
        <source>the newest moment is shown</source>
        <translation>最新の時点を表示しています</translation>
    </message>
    <message>
        <source>no other moment is marked</source>
        <translation>ほかに印を付けた時点がありません</translation>
    </message>
</context>
<context>
    <name>handmap::Plot</name>
    <message>
        <source>Click, or press the left and right keys, to look at another moment</source>
        <translation>クリックまたは左右キーで別の時点を見ます</translation>
    </message>
</context>
<context>
    <name>handmap::PolygonTool</name>
    <message>
        <source>The outline must not cross itself · Backspace takes the last corner back</source>
        <translation>輪郭は自分自身と交差できません · Backspace で最後の角を取り消します</translation>
    </message>
    <message>
        <source>Click the corners of a building, one after the other</source>
        <translation>建物の角を順にクリックします</translation>
    </message>
    <message>
        <source>Enter, a double click or the first corner closes it · Backspace: one back · Esc: cancel</source>
        <translation>Enter、ダブルクリック、または最初の角で閉じます · Backspace: 一つ戻る · Esc: 中止</translation>
    </message>
    <message>
        <source>The next corner, or type length, Tab, angle, Enter · Backspace: one back</source>
        <translation>次の角、または長さ、Tab、角度、Enter を入力 · Backspace: 一つ戻る</translation>
    </message>
</context>
<context>
    <name>handmap::PropertyPage</name>
    <message>
        <source>Id</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>“%1” cannot be the id of %2: ids are not empty and unique</source>
        <translation>「%1」は %2 の ID にできません。ID は空でなく、重複しないものにしてください</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>handmap::RecoveryOffer</name>
    <message>
        <source>An earlier session ended with unsaved changes to “%1”.</source>
        <translation>以前の作業は、「%1」の変更を保存しないまま終わりました。</translation>
    </message>
    <message>
        <source>Re&amp;cover</source>
        <translation>復元(&amp;C)</translation>
    </message>
    <message>
        <source>Disc&amp;ard</source>
        <translation>破棄(&amp;A)</translation>
    </message>
    <message>
        <source>What an earlier session left behind cannot be read: %1</source>
        <translation>以前の作業が残したものを読めません: %1</translation>
    </message>
    <message>
        <source>Closing this message keeps the file.</source>
        <translation>このメッセージを閉じてもファイルは残ります。</translation>
    </message>
    <message>
        <source>Delete the file</source>
        <translation>ファイルを削除</translation>
    </message>
</context>
<context>
    <name>handmap::RectangleTool</name>
    <message>
        <source>Drag from corner to corner, or click both · arrow keys and Enter do it too</source>
        <translation>角から角へドラッグ、または両方をクリック · 矢印キーと Enter でもできます</translation>
    </message>
    <message>
        <source>The opposite corner, or type: 40 Tab 15 Enter · Shift: square · Ctrl: from the centre · Esc: cancel</source>
        <translation>反対の角、または入力: 40 Tab 15 Enter · Shift: 正方形 · Ctrl: 中心から · Esc: 中止</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>奥行き</translation>
    </message>
</context>
<context>
    <name>handmap::ReferenceTrust</name>
    <message>
        <source>“%1” wants to read files outside of its folder: %2</source>
        <translation>「%1」はフォルダーの外のファイルを読もうとしています: %2</translation>
    </message>
    <message>
        <source>Read them only if you know where the drawing comes from.</source>
        <translation>図面の出所がわかる場合だけ読み込んでください。</translation>
    </message>
    <message>
        <source>Read them</source>
        <translation>読み込む</translation>
    </message>
</context>
<context>
    <name>handmap::ResultActions</name>
    <message>
        <source>no run has corrected anything yet</source>
        <translation>まだどの実行も補正していません</translation>
    </message>
    <message>
        <source>Frame %1 was skipped: %2</source>
        <translation>フレーム %1 を飛ばしました: %2</translation>
    </message>
    <message>
        <source>%1 frames were skipped; the latest, %2: %3</source>
        <translation>%1 フレームを飛ばしました。最新は %2: %3</translation>
    </message>
    <message>
        <source>Place the start</source>
        <translation>出発点を置く</translation>
    </message>
    <message>
        <source>The run is done. %1</source>
        <translation>実行が終わりました。%1</translation>
    </message>
    <message>
        <source>Accept correction</source>
        <translation>補正を取り込む</translation>
    </message>
    <message numerus="yes">
        <source>%n building(s) were edited since the run began: %1</source>
        <translation>
            <numerusform>実行開始後に建物 %n 棟が編集されました: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Their corrected shapes belong to the drawing as it was before.</source>
        <translation>それらの補正は、編集前の図面に対するものです。</translation>
    </message>
    <message>
        <source>Take all others</source>
        <translation>その他をすべて取り込む</translation>
    </message>
    <message>
        <source>Take all</source>
        <translation>すべて取り込む</translation>
    </message>
    <message>
        <source>; </source>
        <translation>、</translation>
    </message>
    <message numerus="yes">
        <source>; and %n more</source>
        <translation>
            <numerusform>、ほか %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Look before you accept: %1.</source>
        <translation>取り込む前に見てください: %1。</translation>
    </message>
    <message>
        <source>Review…</source>
        <translation>確認…</translation>
    </message>
    <message>
        <source>The drive goes on. What was recorded of it stays, the rest is missed.</source>
        <translation>走行は続いています。ここまでの記録は残りますが、この先は記録されません。</translation>
    </message>
    <message>
        <source>The drive was not recorded: it cannot be run again.</source>
        <translation>この走行は記録されていません。もう一度実行することはできません。</translation>
    </message>
    <message>
        <source>The drive was not recorded: it cannot be run again. What it has corrected is not in the drawing.</source>
        <translation>この走行は記録されていません。もう一度実行することはできません。補正した内容は図面に入っていません。</translation>
    </message>
    <message>
        <source>What the run has corrected is not in the drawing.</source>
        <translation>実行が補正した内容は図面に入っていません。</translation>
    </message>
    <message>
        <source>&amp;Accept correction</source>
        <translation>補正を取り込む(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Leave it behind</source>
        <translation>残さずに進む(&amp;L)</translation>
    </message>
    <message>
        <source>Leave this run?</source>
        <translation>この実行を離れますか?</translation>
    </message>
    <message>
        <source>The drawing has all of it already: there is nothing to take.</source>
        <translation>すでにすべて図面に取り入れてあります。新しく取り入れるものはありません。</translation>
    </message>
    <message>
        <source>Hatched on the map.</source>
        <translation>地図では斜線で示しています。</translation>
    </message>
</context>
<context>
    <name>handmap::ReviewWords</name>
    <message>
        <source>not recognised: it stays as drawn</source>
        <translation>認識されず：描かれたまま</translation>
    </message>
    <message>
        <source>%1 of %2 walls seen</source>
        <translation>%2 面のうち %1 面の壁が見えた</translation>
    </message>
    <message>
        <source>wrong in about %1 of 100 such cases</source>
        <translation>同様の場合の 100 件中約 %1 件が誤り</translation>
    </message>
    <message>
        <source>not recognised: it moves with the others</source>
        <translation>認識されず：まわりと一緒に移動</translation>
    </message>
</context>
<context>
    <name>handmap::RevisionActions</name>
    <message>
        <source>the robot moves by %1 m</source>
        <translation>ロボットは %1 m 動きます</translation>
    </message>
    <message>
        <source>No building moves; %1.</source>
        <translation>どの建物も動きません。%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n building(s) move by up to %1 m; %2.</source>
        <translation>
            <numerusform>建物 %n 棟が最大 %1 m 動きます。%2。</numerusform>
        </translation>
    </message>
    <message>
        <source>Recomputing with the drawing as it is</source>
        <translation>今の図面で計算し直しています</translation>
    </message>
    <message>
        <source>Recomputing without the poses that were given</source>
        <translation>指定した位置を使わずに計算し直しています</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>The beginning of the run is no longer kept.</source>
        <translation>実行の始めの部分はもう残っていません。</translation>
    </message>
    <message>
        <source>Run its recording with the changed drawing.</source>
        <translation>変更した図面で記録を実行してください。</translation>
    </message>
    <message>
        <source>A run needs at least one building and a start.</source>
        <translation>実行には少なくとも一つの建物と出発点が必要です。</translation>
    </message>
    <message>
        <source>Recomputing with the pose that you gave</source>
        <translation>指定した位置で計算し直しています</translation>
    </message>
    <message>
        <source>Building is right</source>
        <translation>建物は正しい</translation>
    </message>
    <message>
        <source>Recomputing with what is right</source>
        <translation>正しいものを使って計算し直しています</translation>
    </message>
    <message>
        <source>Recomputing without what is not there</source>
        <translation>存在しないものを除いて計算し直しています</translation>
    </message>
    <message>
        <source>Done again. %1</source>
        <translation>やり直しました。%1</translation>
    </message>
    <message>
        <source>The run was done again with the changed drawing. %1</source>
        <translation>変更した図面で実行をやり直しました。%1</translation>
    </message>
    <message>
        <source>The dashed outlines show the new result.</source>
        <translation>破線の輪郭が新しい結果です。</translation>
    </message>
    <message>
        <source>Take the new result</source>
        <translation>新しい結果を採る</translation>
    </message>
    <message>
        <source>Keep the old result</source>
        <translation>元の結果を残す</translation>
    </message>
    <message>
        <source>What you said is not kept beside the recording.</source>
        <translation>指示した内容は記録と一緒に保存されていません。</translation>
    </message>
    <message>
        <source>Recomputing with the poses of the file</source>
        <translation>ファイルの位置を使って計算し直しています</translation>
    </message>
    <message>
        <source>Forget given poses</source>
        <translation>指定した位置を忘れる</translation>
    </message>
    <message>
        <source>Robot is here</source>
        <translation>ロボットはここ</translation>
    </message>
    <message>
        <source>Recomputing with what is still said</source>
        <translation>残りの指示で計算し直しています</translation>
    </message>
    <message>
        <source>The robot was at x %1 m, y %2 m</source>
        <translation>ロボットは x %1 m、y %2 m にいた</translation>
    </message>
    <message>
        <source>%1 is right</source>
        <translation>%1 は正しい</translation>
    </message>
    <message>
        <source>%1 is not there</source>
        <translation>%1 は存在しない</translation>
    </message>
    <message>
        <source>The poses given before do not count</source>
        <translation>それまでに指定した位置は使わない</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 秒: %2</translation>
    </message>
    <message>
        <source>Open given poses</source>
        <translation>既知の姿勢を開く</translation>
    </message>
    <message>
        <source>It is locked: unlock it first.</source>
        <translation>ロックされています。先に解除してください。</translation>
    </message>
    <message>
        <source>Building is not there</source>
        <translation>建物は存在しない</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z) takes it back.</source>
        <translation>元に戻す (Ctrl+Z) で取り消せます。</translation>
    </message>
    <message>
        <source>What you said</source>
        <translation>言ったこと</translation>
    </message>
    <message>
        <source>no run shows a robot yet</source>
        <translation>まだロボットを表示する実行がありません</translation>
    </message>
    <message>
        <source>the drawing is the one that was run with</source>
        <translation>図面は実行したときのままです</translation>
    </message>
    <message>
        <source>no building is selected</source>
        <translation>建物が選択されていません</translation>
    </message>
    <message>
        <source>no pose was given</source>
        <translation>指定した位置がありません</translation>
    </message>
    <message>
        <source>the run is being done again</source>
        <translation>実行をやり直しているところです</translation>
    </message>
    <message>
        <source>the run is ending</source>
        <translation>実行が終わるところです</translation>
    </message>
    <message>
        <source>the beginning of the run is no longer kept</source>
        <translation>実行の始めはもう残っていません</translation>
    </message>
</context>
<context>
    <name>handmap::RigActions</name>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
</context>
<context>
    <name>handmap::RigDialog</name>
    <message>
        <source>&amp;Try</source>
        <translation>試す(&amp;T)</translation>
    </message>
    <message>
        <source>Connect a robot</source>
        <translation>ロボットを接続</translation>
    </message>
    <message>
        <source>Press Try: what the robot sees appears here.</source>
        <translation>「試す」を押すと、ロボットに見えるものがここに現れます。</translation>
    </message>
    <message>
        <source>Open all devices and look at what they say</source>
        <translation>すべての機器を開き、その応答を見ます</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;List ports anew</source>
        <translation>ポートを再検索(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Use this robot</source>
        <translation>このロボットを使う(&amp;U)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>保存しました: %1</translation>
    </message>
    <message>
        <source>Open a rig</source>
        <translation>構成を開く</translation>
    </message>
    <message>
        <source>Save the rig</source>
        <translation>構成を保存</translation>
    </message>
    <message>
        <source>Stop &amp;trying</source>
        <translation>試すのをやめる(&amp;T)</translation>
    </message>
    <message>
        <source>Waiting for the first picture</source>
        <translation>最初の画像を待っています</translation>
    </message>
</context>
<context>
    <name>handmap::RigForm</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>記録しない</translation>
    </message>
    <message>
        <source>Each run gets a new folder in it</source>
        <translation>実行ごとに、この中に新しいフォルダーを作ります</translation>
    </message>
    <message>
        <source>Record into</source>
        <translation>記録先</translation>
    </message>
    <message>
        <source>My robot</source>
        <translation>私のロボット</translation>
    </message>
    <message>
        <source>Stereo camera, both images in one</source>
        <translation>ステレオカメラ (左右が一枚の画像)</translation>
    </message>
    <message>
        <source>Two cameras</source>
        <translation>カメラ二台</translation>
    </message>
    <message>
        <source>Laser scanner: Hokuyo</source>
        <translation>レーザースキャナー: 北陽</translation>
    </message>
    <message>
        <source>Laser scanner: RPLIDAR</source>
        <translation>レーザースキャナー: RPLIDAR</translation>
    </message>
    <message>
        <source>Laser scanner over ROS</source>
        <translation>ROS 経由のレーザースキャナー</translation>
    </message>
    <message>
        <source>Point cloud over ROS</source>
        <translation>ROS 経由の点群</translation>
    </message>
    <message>
        <source>Sees with</source>
        <translation>見るもの</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Right camera</source>
        <translation>右カメラ</translation>
    </message>
    <message>
        <source>calib.yml as “handmap-cli calibrate” writes it</source>
        <translation>「handmap-cli calibrate」が書き出す calib.yml</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>校正</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>画像の幅</translation>
    </message>
    <message>
        <source>Image height</source>
        <translation>画像の高さ</translation>
    </message>
    <message>
        <source>as it comes</source>
        <translation>そのまま</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>スキャナー</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>トピック</translation>
    </message>
    <message>
        <source>Sensor ahead</source>
        <translation>センサーの前方位置</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Sensor left</source>
        <translation>センサーの左方位置</translation>
    </message>
    <message>
        <source>Sensor height</source>
        <translation>センサーの高さ</translation>
    </message>
    <message>
        <source>Turned left</source>
        <translation>左への回転</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Looks down by</source>
        <translation>下向きの角度</translation>
    </message>
    <message>
        <source>Sees at most</source>
        <translation>見える最大距離</translation>
    </message>
    <message>
        <source>It stops, and a pan-tilt head (PTU-D46) looks around</source>
        <translation>止まって、雲台 (PTU-D46) で見回す</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>雲台</translation>
    </message>
    <message>
        <source>Wheels: lines of text</source>
        <translation>車輪: テキスト行</translation>
    </message>
    <message>
        <source>Wheels over ROS</source>
        <translation>ROS 経由の車輪</translation>
    </message>
    <message>
        <source>No wheels: the images</source>
        <translation>車輪なし: 画像から</translation>
    </message>
    <message>
        <source>No wheels: the scans</source>
        <translation>車輪なし: スキャンから</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Wheels</source>
        <translation>車輪</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>フォルダーを選ぶ</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>ファイルを選ぶ</translation>
    </message>
    <message>
        <source>Calibration of the camera</source>
        <translation>カメラの校正</translation>
    </message>
    <message>
        <source>Calibrations (*.yml *.yaml *.xml *.txt)</source>
        <translation>校正ファイル (*.yml *.yaml *.xml *.txt)</translation>
    </message>
    <message>
        <source>The rig</source>
        <translation>ロボットの構成</translation>
    </message>
    <message>
        <source>Two cameras over ROS</source>
        <translation>ROS 経由のカメラ二台</translation>
    </message>
    <message>
        <source>Topic of the left</source>
        <translation>左のトピック</translation>
    </message>
    <message>
        <source>Topic of the right</source>
        <translation>右のトピック</translation>
    </message>
    <message>
        <source>Send to ROS</source>
        <translation>ROS へ送る</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Foxglove connects to this port; its own choice is 8765</source>
        <translation>Foxglove がこのポートに接続します (標準は 8765)</translation>
    </message>
    <message>
        <source>Foxglove port</source>
        <translation>Foxglove のポート</translation>
    </message>
    <message>
        <source>From other machines too</source>
        <translation>他の計算機からも</translation>
    </message>
    <message>
        <source>Choose the left camera.</source>
        <translation>左カメラを選んでください。</translation>
    </message>
    <message>
        <source>Choose a camera.</source>
        <translation>カメラを選んでください。</translation>
    </message>
    <message>
        <source>Choose the right camera.</source>
        <translation>右カメラを選んでください。</translation>
    </message>
    <message>
        <source>Enter the topic of the left images.</source>
        <translation>左画像のトピックを入力してください。</translation>
    </message>
    <message>
        <source>Enter the topic of the right images.</source>
        <translation>右画像のトピックを入力してください。</translation>
    </message>
    <message>
        <source>Choose the calibration of the camera: calib.yml.</source>
        <translation>カメラの校正 (calib.yml) を選んでください。</translation>
    </message>
    <message>
        <source>Choose where the scanner is connected.</source>
        <translation>スキャナーの接続先を選んでください。</translation>
    </message>
    <message>
        <source>Enter the topic of the scanner.</source>
        <translation>スキャナーのトピックを入力してください。</translation>
    </message>
    <message>
        <source>Choose where the head is connected.</source>
        <translation>雲台の接続先を選んでください。</translation>
    </message>
    <message>
        <source>Choose where the wheels are connected.</source>
        <translation>車輪の接続先を選んでください。</translation>
    </message>
    <message>
        <source>Enter the topic of the wheels.</source>
        <translation>車輪のトピックを入力してください。</translation>
    </message>
    <message>
        <source>A robot that stops to look around needs wheels that measure its motion.</source>
        <translation>止まって見回すロボットには、動きを示す車輪が必要です。</translation>
    </message>
    <message>
        <source>A device (/dev/video0), a video file, or the URL of a network camera; on FireWire the number of the head or “first”; of GigE and USB3 Vision its name</source>
        <translation>装置（/dev/video0）、動画ファイル、またはネットワークカメラの URL。FireWire では装置の番号か「first」、GigE・USB3 Vision では装置の名前</translation>
    </message>
    <message>
        <source>Stereo head on FireWire (Bumblebee)</source>
        <translation>FireWire のステレオカメラ（Bumblebee）</translation>
    </message>
    <message>
        <source>Two GigE or USB3 Vision cameras</source>
        <translation>GigE・USB3 Vision カメラ2台</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>校正…</translation>
    </message>
    <message>
        <source>Hold a checkerboard before the cameras</source>
        <translation>カメラの前に市松模様の板をかざす</translation>
    </message>
    <message>
        <source>Motion from</source>
        <translation>動きの情報源</translation>
    </message>
    <message>
        <source>Pose, frames, occupancy grid and buildings are published there, and /initialpose is heard</source>
        <translation>姿勢、座標系、占有格子、建物をそこに送り、/initialpose を聞きます</translation>
    </message>
    <message>
        <source>Version of ROS</source>
        <translation>ROS の版</translation>
    </message>
    <message>
        <source>A serial port (/dev/ttyUSB0, with a rate: /dev/ttyUSB0@115200) or an address (192.168.0.10, host:port); of ROS a rosbridge (ws://host:9090) or a Foxglove bridge (foxglove://host:8765)</source>
        <translation>シリアルポート（/dev/ttyUSB0、速度つきは /dev/ttyUSB0@115200）またはアドレス（192.168.0.10、host:port）。ROS なら rosbridge（ws://host:9090）または Foxglove bridge（foxglove://host:8765）</translation>
    </message>
    <message>
        <source>Bridge to ROS</source>
        <translation>ROS へのブリッジ</translation>
    </message>
    <message>
        <source>not sent; ws://host:9090 or foxglove://host:8765</source>
        <translation>送らない。ws://host:9090 または foxglove://host:8765</translation>
    </message>
    <message>
        <source>Enter where the bridge to ROS is: ws://host:9090 or foxglove://host:8765.</source>
        <translation>ROS へのブリッジの場所を入力してください: ws://host:9090 または foxglove://host:8765</translation>
    </message>
    <message>
        <source>ws://host:9090 or foxglove://host:8765</source>
        <translation>ws://host:9090 または foxglove://host:8765</translation>
    </message>
    <message>
        <source>/dev/ttyUSB0, or an address</source>
        <translation>/dev/ttyUSB0、またはアドレス</translation>
    </message>
    <message>
        <source>empty: as the robot says (camera_info)</source>
        <translation>空欄: ロボットの camera_info に従います</translation>
    </message>
</context>
<context>
    <name>handmap::RigPreviewView</name>
    <message>
        <source>%1 m around</source>
        <translation>周囲 %1 m</translation>
    </message>
</context>
<context>
    <name>handmap::RobotMapLayer</name>
    <message>
        <source>Where “%1” lies on the drawing is being looked for…</source>
        <translation>「%1」が図面のどこに当たるかを探しています…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>“%1” lies as it does in its own frame.</source>
        <translation>「%1」は自身の座標系のとおりに置かれました。</translation>
    </message>
    <message>
        <source>No building is drawn on which it could be laid: draw upon it.</source>
        <translation>合わせる建物がまだ描かれていません。この上に描いてください。</translation>
    </message>
    <message>
        <source>There are no straight walls in it by which it could be laid on the drawing.</source>
        <translation>図面に合わせる手がかりになるまっすぐな壁がありません。</translation>
    </message>
    <message>
        <source>It would lie nearly as well %1 m from there, turned by %2°: look whether it is the right place.</source>
        <translation>そこから %1 m 離れ %2° 回った所にもほぼ同じほど合います。正しい場所か確かめてください。</translation>
    </message>
    <message>
        <source>What is drawn is %1 % larger than what the robot has.</source>
        <translation>図面はロボットの地図より %1 % 大きく描かれています。</translation>
    </message>
    <message>
        <source>What is drawn is %1 % smaller than what the robot has.</source>
        <translation>図面はロボットの地図より %1 % 小さく描かれています。</translation>
    </message>
    <message>
        <source>Of the walls that faced what it saw, only %1 % are there: it may be of another place.</source>
        <translation>見えていたはずの壁のうち、あるのは %1 % だけです。別の場所の地図かもしれません。</translation>
    </message>
    <message>
        <source>“%1” lies on the drawing: of the walls that faced what it saw, %2 % are there, half of them within %3 m and nine of ten within %4 m.</source>
        <translation>「%1」を図面に合わせました。見えていたはずの壁の %2 % があり、その半分は %3 m 以内、九割は %4 m 以内です。</translation>
    </message>
    <message>
        <source>“%1” does not fit the drawing.</source>
        <translation>「%1」は図面に合いません。</translation>
    </message>
</context>
<context>
    <name>handmap::RobotPointer</name>
    <message>
        <source>The robot is out of view: click to go there</source>
        <translation>ロボットは画面の外です：クリックするとそこへ移動します</translation>
    </message>
</context>
<context>
    <name>handmap::RobotPoseTool</name>
    <message>
        <source>Press where the robot is now, drag to where it looks</source>
        <translation>ロボットが今いる場所を押し、見る方向へドラッグします</translation>
    </message>
</context>
<context>
    <name>handmap::RouteTool</name>
    <message>
        <source>Click the points of the robot&apos;s way</source>
        <translation>ロボットの通る点をクリックします</translation>
    </message>
    <message>
        <source>Click to lengthen the route · Backspace: one point back · Enter or Esc: done</source>
        <translation>クリックで経路を延ばします · Backspace: 一点戻る · Enter または Esc: 完了</translation>
    </message>
</context>
<context>
    <name>handmap::RunExports</name>
    <message>
        <source>no run has corrected anything yet</source>
        <translation>まだどの実行も補正していません</translation>
    </message>
    <message>
        <source>no run has come to its end yet</source>
        <translation>まだどの実行も終わりまで進んでいません</translation>
    </message>
    <message>
        <source>Export the corrected map</source>
        <translation>補正した地図を書き出す</translation>
    </message>
    <message>
        <source>-corrected</source>
        <translation>-補正</translation>
    </message>
    <message>
        <source>The corrected map</source>
        <translation>補正した地図</translation>
    </message>
    <message>
        <source>Export the trajectory</source>
        <translation>軌跡を書き出す</translation>
    </message>
    <message>
        <source>Trajectories (*.tum)</source>
        <translation>軌跡 (*.tum)</translation>
    </message>
    <message>
        <source>The way of the robot</source>
        <translation>ロボットの軌跡</translation>
    </message>
    <message>
        <source>Export a report</source>
        <translation>レポートを書き出す</translation>
    </message>
    <message>
        <source>-report</source>
        <translation>-レポート</translation>
    </message>
    <message>
        <source>Pages (*.html *.pdf)</source>
        <translation>ページ (*.html *.pdf)</translation>
    </message>
    <message>
        <source>The report of the run</source>
        <translation>実行のレポート</translation>
    </message>
    <message>
        <source>Export the run as MCAP</source>
        <translation>実行を MCAP で書き出す</translation>
    </message>
    <message>
        <source>-run</source>
        <translation>-実行</translation>
    </message>
    <message>
        <source>MCAP (*.mcap)</source>
        <translation>MCAP (*.mcap)</translation>
    </message>
    <message>
        <source>The run</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Export the run as a film</source>
        <translation>実行を動画で書き出す</translation>
    </message>
    <message>
        <source>Films (*.mp4 *.webm *.mkv *.avi)</source>
        <translation>動画 (*.mp4 *.webm *.mkv *.avi)</translation>
    </message>
    <message>
        <source>The film of the run</source>
        <translation>実行の動画</translation>
    </message>
    <message>
        <source>a live drive is recorded as it goes on</source>
        <translation>ライブ走行は走行中に記録されます</translation>
    </message>
    <message>
        <source>there is no robot yet</source>
        <translation>ロボットがまだありません</translation>
    </message>
    <message>
        <source>A new folder for the recording</source>
        <translation>記録のための新しいフォルダー</translation>
    </message>
    <message>
        <source>-recording</source>
        <translation>-記録</translation>
    </message>
    <message>
        <source>The recording</source>
        <translation>記録</translation>
    </message>
</context>
<context>
    <name>handmap::RunPanels</name>
    <message>
        <source>Run settings</source>
        <translation>実行の設定</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>What you said</source>
        <translation>言ったこと</translation>
    </message>
</context>
<context>
    <name>handmap::RunSetupPanel</name>
    <message>
        <source>Handmap</source>
        <translation>Handmap</translation>
    </message>
    <message>
        <source>Published FastSLAM/PSOM</source>
        <translation>論文の FastSLAM/PSOM</translation>
    </message>
    <message>
        <source>Handmap&apos;s own method, or the published one to the letter</source>
        <translation>Handmap の方法、または論文どおりの方法</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Scale unknown</source>
        <translation>縮尺が不明</translation>
    </message>
    <message>
        <source>The drawing may be 0.7 to 1.4 times as large as the place</source>
        <translation>図面は実際の 0.7 倍から 1.4 倍の大きさかもしれない</translation>
    </message>
    <message>
        <source>Turn unknown</source>
        <translation>向きが不明</translation>
    </message>
    <message>
        <source>The drawing may be turned by up to 40° about the robot&apos;s start</source>
        <translation>図面はロボットの出発点を中心に最大 40° 回っているかもしれない</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>図面</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>Poses of the robot that are followed at once</source>
        <translation>同時に追うロボットの位置の数</translation>
    </message>
    <message>
        <source>Swarm</source>
        <translation>群れ</translation>
    </message>
    <message>
        <source>Points of the swarm that corrects a building</source>
        <translation>建物を補正する群れの点の数</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>反復</translation>
    </message>
    <message>
        <source>Moves of a swarm in one observation, at most</source>
        <translation>一観測での群れの最大移動回数</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>乱数の種</translation>
    </message>
    <message>
        <source>The same seed and the same inputs give the same result</source>
        <translation>同じ種と同じ入力からは同じ結果が得られます</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>スレッド</translation>
    </message>
    <message>
        <source>The result does not depend on it</source>
        <translation>結果はこれによりません</translation>
    </message>
    <message>
        <source>all</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Found by the program</source>
        <translation>プログラムが見つける</translation>
    </message>
    <message>
        <source>Every wall counts</source>
        <translation>すべての壁を使う</translation>
    </message>
    <message>
        <source>How buildings are distinguished from trees and hedges in images; with Teach Buildings you make a way of your own</source>
        <translation>画像で建物を木や生け垣と見分ける方法。「建物を教える」で自分のものを作れます</translation>
    </message>
    <message>
        <source>Buildings in images</source>
        <translation>画像の建物</translation>
    </message>
    <message>
        <source>Images, else points</source>
        <translation>画像、なければ点</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>What is taken of a recording</source>
        <translation>記録のどれを使うか</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>情報源</translation>
    </message>
    <message>
        <source>From frame</source>
        <translation>最初のフレーム</translation>
    </message>
    <message>
        <source>First frame of a recording</source>
        <translation>記録の最初のフレーム</translation>
    </message>
    <message>
        <source>To frame</source>
        <translation>最後のフレーム</translation>
    </message>
    <message>
        <source>Last frame of a recording</source>
        <translation>記録の最後のフレーム</translation>
    </message>
    <message>
        <source>end</source>
        <translation>終わり</translation>
    </message>
    <message>
        <source>How many observations are used: all of them, or one of every so many</source>
        <translation>使う観測の数: すべて、または何個に一つ</translation>
    </message>
    <message>
        <source>Found as taught</source>
        <translation>教えたとおりに見つける</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>観測</translation>
    </message>
    <message>
        <source>one of </source>
        <translation>何個に一つ：</translation>
    </message>
</context>
<context>
    <name>handmap::RunStrip</name>
    <message>
        <source>How far off the shown place is at most, nine times of ten</source>
        <translation>示された位置のずれは、十回に九回これ以下です</translation>
    </message>
    <message>
        <source>Where the robot is</source>
        <translation>ロボットの位置</translation>
    </message>
    <message>
        <source>Whether the view follows the robot: off, follow, follow and turn</source>
        <translation>表示がロボットを追うか: なし、追う、追って回す</translation>
    </message>
    <message>
        <source>Follow: off</source>
        <translation>追尾: なし</translation>
    </message>
    <message>
        <source>Follow: on</source>
        <translation>追尾: あり</translation>
    </message>
    <message>
        <source>Follow: and turn</source>
        <translation>追尾: 回転も</translation>
    </message>
</context>
<context>
    <name>handmap::RunViews</name>
    <message>
        <source>Phase %1 of %2: %3. %4</source>
        <translation>段階 %1/%2: %3。%4</translation>
    </message>
    <message>
        <source>no run has corrected anything yet</source>
        <translation>まだどの実行も補正していません</translation>
    </message>
    <message>
        <source>no run shows a robot yet</source>
        <translation>まだロボットを表示する実行がありません</translation>
    </message>
</context>
<context>
    <name>handmap::RunWorker</name>
    <message>
        <source>The run needs more memory than there is.</source>
        <translation>実行に必要なメモリがありません。</translation>
    </message>
    <message>
        <source>A shorter stretch of the recording needs less, and by the published method fewer particles.</source>
        <translation>記録の区間を短くするか、論文の方法では粒子を減らすと少なくなります。</translation>
    </message>
    <message>
        <source>The run ended with an unexpected error: %1</source>
        <translation>実行が予期しない問題で終わりました: %1</translation>
    </message>
</context>
<context>
    <name>handmap::SaidActs</name>
    <message>
        <source>Take back what was said</source>
        <translation>指示を取り消す</translation>
    </message>
</context>
<context>
    <name>handmap::SaidPanel</name>
    <message>
        <source>What you said</source>
        <translation>言ったこと</translation>
    </message>
    <message>
        <source>Take it back: the run is done again without it</source>
        <translation>取り消す: これなしで実行をやり直します</translation>
    </message>
    <message>
        <source>Take back: %1</source>
        <translation>取り消す: %1</translation>
    </message>
    <message>
        <source>Robot is here, Building is right and Building is not there are listed here while the run is there.</source>
        <translation>実行がある間、「ロボットはここ」「建物は正しい」「建物は存在しない」がここに並びます。</translation>
    </message>
</context>
<context>
    <name>handmap::SelectTool</name>
    <message>
        <source>Release to select what the frame touches · Shift adds to it</source>
        <translation>離すと枠に触れるものを選択 · Shift で追加</translation>
    </message>
    <message>
        <source>Release to turn · Shift: steps of 15° · Esc: cancel</source>
        <translation>離すと向きを決定 · Shift: 15° ごと · Esc: 中止</translation>
    </message>
    <message>
        <source>Drag a point to bend the route, a line to move it · Del removes</source>
        <translation>点のドラッグで経路を曲げ、線のドラッグで移動 · Del で削除</translation>
    </message>
    <message>
        <source>Drag to move · handles resize and turn · arrow keys nudge · Del removes</source>
        <translation>ドラッグで移動 · ハンドルで大きさと向きを変更 · 矢印キーで微調整 · Del で削除</translation>
    </message>
    <message>
        <source>Drag to move · arrow keys nudge · Del removes · Shift adds to the selection</source>
        <translation>ドラッグで移動 · 矢印キーで微調整 · Del で削除 · Shift で選択に追加</translation>
    </message>
    <message>
        <source>Nudge</source>
        <translation>微調整</translation>
    </message>
    <message>
        <source>The outline must not cross itself</source>
        <translation>輪郭は自分自身と交差できません</translation>
    </message>
    <message>
        <source>Release to resize · Ctrl: about the centre · Alt: no snapping · Esc: cancel</source>
        <translation>離すと大きさを決定 · Ctrl: 中心を保つ · Alt: スナップなし · Esc: 中止</translation>
    </message>
    <message>
        <source>Release to place it · Alt: no snapping · Esc: cancel</source>
        <translation>離すと置きます · Alt: スナップなし · Esc: 中止</translation>
    </message>
    <message>
        <source>Arrow keys move the corner · Ins adds one · Del removes it · Tab: the next</source>
        <translation>矢印キーで角を移動 · Ins で追加 · Del で削除 · Tab: 次の角</translation>
    </message>
    <message>
        <source>Click or drag a frame to select · Shift adds · Tab: the next · Space pans</source>
        <translation>クリックまたは枠のドラッグで選択 · Shift で追加 · Tab: 次へ · Space で移動</translation>
    </message>
    <message>
        <source>It is locked · Ctrl+L unlocks it</source>
        <translation>ロックされています · Ctrl+L で解除</translation>
    </message>
    <message>
        <source>Drag corners, or a dot to add one · Enter: corners by keys · arrow keys nudge</source>
        <translation>角をドラッグ、点をドラッグで角を追加 · Enter: キーで角を編集 · 矢印キーで微調整</translation>
    </message>
    <message>
        <source>Add Corner</source>
        <translation>角を追加</translation>
    </message>
    <message>
        <source>Delete Corner</source>
        <translation>角を削除</translation>
    </message>
    <message>
        <source>Move Corner</source>
        <translation>角を移動</translation>
    </message>
</context>
<context>
    <name>handmap::SourceActions</name>
    <message>
        <source>&amp;Two rows of buildings</source>
        <translation>二列の建物(&amp;T)</translation>
    </message>
    <message>
        <source>A &amp;campus</source>
        <translation>キャンパス(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Around a campus</source>
        <translation>キャンパス一周(&amp;A)</translation>
    </message>
    <message>
        <source>A &amp;quarter with fences and hedges</source>
        <translation>柵と生け垣のある街区(&amp;Q)</translation>
    </message>
    <message>
        <source>A &amp;live robot (virtual rig)</source>
        <translation>動作中のロボット（仮想）(&amp;L)</translation>
    </message>
    <message>
        <source>A live robot with a &amp;stereo head</source>
        <translation>ステレオカメラで見回す動作中のロボット(&amp;S)</translation>
    </message>
    <message>
        <source>no recording or simulator is open</source>
        <translation>記録もシミュレーターも開いていません</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>記録を開く</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is open: %n frame(s).</source>
        <translation>
            <numerusform>「%1」を開きました: %n フレーム</numerusform>
        </translation>
    </message>
    <message>
        <source>Press Run to localize on the drawing.</source>
        <translation>「実行」を押すと、図面の上で位置を推定します。</translation>
    </message>
    <message>
        <source>Draw the buildings and where the robot starts, or open the drawing; then press Run.</source>
        <translation>建物とロボットの出発点を描くか、図面を開いてから、「実行」を押してください。</translation>
    </message>
    <message numerus="yes">
        <source>On that drive somebody said %n thing(s): where the robot was, or which building is right or not there. The run does it again.</source>
        <translation>
            <numerusform>この走行では人が %n 件の指示をしました (ロボットの位置、正しい建物、存在しない建物)。実行でも同じことをします。</numerusform>
        </translation>
    </message>
    <message>
        <source>Leave it out</source>
        <translation>使わない</translation>
    </message>
    <message>
        <source>Open poses of the robot</source>
        <translation>ロボットの姿勢を開く</translation>
    </message>
    <message>
        <source>Poses in TUM form (*.tum *.txt)</source>
        <translation>TUM 形式の姿勢 (*.tum *.txt)</translation>
    </message>
    <message numerus="yes">
        <source>The next run goes through %n given pose(s).</source>
        <translation>
            <numerusform>次の実行は既知の姿勢 %n 個を通ります。</numerusform>
        </translation>
    </message>
    <message>
        <source>Forget them</source>
        <translation>使わない</translation>
    </message>
    <message>
        <source>Buildings that are right</source>
        <translation>正しい建物</translation>
    </message>
    <message>
        <source>There are no buildings yet to find the robot among.</source>
        <translation>ロボットの位置を見つける手がかりとなる建物がまだありません。</translation>
    </message>
    <message>
        <source>Draw at least one that the robot comes by.</source>
        <translation>ロボットがそばを通る建物を、少なくとも一つ描いてください。</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>描く</translation>
    </message>
    <message>
        <source>The map has no start.</source>
        <translation>地図に出発点がありません。</translation>
    </message>
    <message>
        <source>Press where the robot begins, drag to where it looks, release.</source>
        <translation>ロボットの出発点を押し、見る方向へドラッグして離します。</translation>
    </message>
    <message>
        <source>Place the start</source>
        <translation>出発点を置く</translation>
    </message>
    <message>
        <source>Import a log</source>
        <translation>ログの取り込み</translation>
    </message>
    <message>
        <source>A new folder for the recording</source>
        <translation>記録のための新しいフォルダー</translation>
    </message>
    <message>
        <source>The d&amp;emonstration</source>
        <translation>デモ(&amp;E)</translation>
    </message>
    <message>
        <source>“%1” is the robot now.</source>
        <translation>いまのロボットは「%1」です。</translation>
    </message>
    <message>
        <source>Press Run; Stop ends the drive.</source>
        <translation>「実行」を押します。「停止」で走行が終わります。</translation>
    </message>
    <message>
        <source>Draw where it starts: press, drag to where it looks, release. Then press Run; Stop ends the drive.</source>
        <translation>ロボットの出発点を押し、見る方向へドラッグして離します。それから「実行」を押します。「停止」で走行が終わります。</translation>
    </message>
    <message>
        <source>A recording is being made of “%1”…</source>
        <translation>「%1」から記録を作っています…</translation>
    </message>
    <message>
        <source>Of what was imported:</source>
        <translation>取り込みについて：</translation>
    </message>
    <message>
        <source>Logs and bags (%1)</source>
        <translation>ログとバッグ (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>handmap::StartPage</name>
    <message>
        <source>Start of the robot</source>
        <translation>ロボットの出発点</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Position ±</source>
        <translation>位置 ±</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>How far the robot may begin from there; 0: exactly there</source>
        <translation>ロボットがそこからどれだけ離れて始まり得るか。0: ちょうどそこ</translation>
    </message>
    <message>
        <source>Heading ±</source>
        <translation>向き ±</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How far it may look to either side of that</source>
        <translation>向きが左右にどれだけずれ得るか</translation>
    </message>
</context>
<context>
    <name>handmap::StartTool</name>
    <message>
        <source>Press where the robot starts, drag to where it looks</source>
        <translation>ロボットの出発点を押し、見る方向へドラッグします</translation>
    </message>
    <message>
        <source>Release to finish, or type the heading · Shift: steps of 15° · Esc: cancel</source>
        <translation>離すと完了、または向きを入力 · Shift: 15° ごと · Esc: 中止</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>向き</translation>
    </message>
</context>
<context>
    <name>handmap::SummaryPage</name>
    <message>
        <source>Selection</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>%1 objects of several kinds</source>
        <translation>複数の種類のオブジェクト %1 個</translation>
    </message>
    <message>
        <source>Route through %1 points, %2 m long</source>
        <translation>%1 点を通る経路、%2 m</translation>
    </message>
</context>
<context>
    <name>handmap::SureBox</name>
    <message>
        <source>sure</source>
        <translation>確か</translation>
    </message>
    <message>
        <source>roughly</source>
        <translation>だいたい</translation>
    </message>
    <message>
        <source>a guess</source>
        <translation>推測</translation>
    </message>
    <message>
        <source>in numbers</source>
        <translation>数値で</translation>
    </message>
</context>
<context>
    <name>handmap::TeachPanel</name>
    <message>
        <source>Use colours</source>
        <translation>色を使う</translation>
    </message>
    <message>
        <source>Save model…</source>
        <translation>モデルを保存…</translation>
    </message>
    <message>
        <source>Save with the map</source>
        <translation>地図とともに保存</translation>
    </message>
    <message>
        <source>Open images…</source>
        <translation>画像を開く…</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>建物</translation>
    </message>
    <message>
        <source>Not a building</source>
        <translation>建物ではない</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>消す</translation>
    </message>
    <message>
        <source>What the left button paints; the right one erases</source>
        <translation>左ボタンで塗るもの。右ボタンは消します</translation>
    </message>
    <message>
        <source>%1 × %1 windows</source>
        <translation>%1 × %1 窓</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>塗る(&amp;P)</translation>
    </message>
    <message>
        <source>Without, the model also suits cameras that see grey</source>
        <translation>使わないと、白黒カメラにも合うモデルになります</translation>
    </message>
    <message>
        <source>Beside the drawing, which takes it up whenever it is opened</source>
        <translation>図面の横に保存し、図面を開くたびに使われます</translation>
    </message>
    <message>
        <source>Load model…</source>
        <translation>モデルを読み込む…</translation>
    </message>
    <message>
        <source>Open images</source>
        <translation>画像を開く</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg)</source>
        <translation>画像 (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>モデルを保存</translation>
    </message>
    <message>
        <source>Load a model</source>
        <translation>モデルを読み込む</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>&amp;Train</source>
        <translation>学習(&amp;T)</translation>
    </message>
    <message>
        <source>Painted: %1 windows of buildings, %2 of others.</source>
        <translation>塗った窓: 建物 %1、その他 %2。</translation>
    </message>
    <message>
        <source> Paint at least %1 of each to train.</source>
        <translation> 学習するには、それぞれ %1 以上塗ってください。</translation>
    </message>
    <message>
        <source>&lt;br&gt;The model (crosses): balanced accuracy &lt;b&gt;%1 %&lt;/b&gt;, precision %2 %, recall %3 %, cross-validated on %4 windows.</source>
        <translation>&lt;br&gt;モデル (×印): 平均正解率 &lt;b&gt;%1 %&lt;/b&gt;、適合率 %2 %、再現率 %3 % (%4 窓で交差検証)</translation>
    </message>
    <message>
        <source>Your own images</source>
        <translation>自分の画像</translation>
    </message>
</context>
<context>
    <name>handmap::TeachView</name>
    <message>
        <source>Open some of your own images, paint where there are buildings and where there are none, then train.</source>
        <translation>自分の画像を何枚か開き、建物のある所とない所を塗って、学習させてください。</translation>
    </message>
</context>
<context>
    <name>handmap::TemplateMenu</name>
    <message>
        <source>A street, houses on both sides</source>
        <translation>両側に家の並ぶ通り</translation>
    </message>
    <message>
        <source>A crossroads</source>
        <translation>交差点</translation>
    </message>
    <message>
        <source>A campus around a yard</source>
        <translation>中庭のあるキャンパス</translation>
    </message>
    <message>
        <source>Keep as a template</source>
        <translation>テンプレートとして保存</translation>
    </message>
    <message>
        <source>Handmap drawings (*.handmap)</source>
        <translation>Handmap の図面 (*.handmap)</translation>
    </message>
    <message>
        <source>My template</source>
        <translation>私のテンプレート</translation>
    </message>
    <message>
        <source>The drawing can be begun with under File / New from Template.</source>
        <translation>「ファイル」→「テンプレートから新規作成」で、この図面から始められます。</translation>
    </message>
    <message>
        <source>New fro&amp;m Template</source>
        <translation>テンプレートから新規作成(&amp;M)</translation>
    </message>
</context>
<context>
    <name>handmap::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>Click: look at that moment · Shift+drag: play this again and again</source>
        <translation>クリック: その時点を見る · Shift+ドラッグ: この区間を繰り返し再生</translation>
    </message>
    <message>
        <source>Bookmark at %1</source>
        <translation>%1 のブックマーク</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>The next run begins with frame %1 · drag it</source>
        <translation>次の実行はフレーム %1 から · ドラッグで変更</translation>
    </message>
    <message>
        <source>The next run ends with frame %1 · drag it</source>
        <translation>次の実行はフレーム %1 まで · ドラッグで変更</translation>
    </message>
</context>
<context>
    <name>handmap::Tour</name>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>ツアー</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>ツアーを終える</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 / %2: %3</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
</context>
<context>
    <name>handmap::TransportActions</name>
    <message>
        <source>a run is under way</source>
        <translation>実行中です</translation>
    </message>
    <message>
        <source>no recording, robot or simulator is open</source>
        <translation>記録、ロボット、シミュレーターのどれも開かれていません</translation>
    </message>
    <message>
        <source>nothing is running</source>
        <translation>何も実行されていません</translation>
    </message>
    <message>
        <source>, %1 of %2</source>
        <translation>、%1 / %2</translation>
    </message>
    <message>
        <source>, %1</source>
        <translation>、%1</translation>
    </message>
    <message>
        <source>Looking back</source>
        <translation>過去を表示中</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>実行中</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>開いています</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Finishing</source>
        <translation>仕上げ中</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Ready to run</source>
        <translation>実行できます</translation>
    </message>
    <message>
        <source>No robot</source>
        <translation>ロボットなし</translation>
    </message>
    <message>
        <source>The run begins with frame %1 of the recording, as you have chosen.</source>
        <translation>選んだとおり、記録のフレーム %1 から実行します。</translation>
    </message>
    <message>
        <source>The robot is taken to be at the start of the drawing then.</source>
        <translation>そのときロボットは図面の出発点にいるものとします。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>handmap::TransportBar</name>
    <message>
        <source>Speed: times the clock of the recording</source>
        <translation>速さ: 記録の時計の何倍か</translation>
    </message>
    <message>
        <source>No robot yet</source>
        <translation>ロボットはまだありません</translation>
    </message>
    <message>
        <source>Where the observations come from</source>
        <translation>観測の出どころ</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>%1 · %2 s</source>
        <translation>%1 · %2 秒</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>%1 %%2</source>
        <translation>%1 %%2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>handmap::UnderlayItem</name>
    <message>
        <source>outside of the folder of the drawing</source>
        <translation>図面のフォルダーの外にあります</translation>
    </message>
    <message>
        <source>there is not enough memory for it</source>
        <translation>メモリが足りません</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 を読んでいます…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>handmap::VertexTable</name>
    <message>
        <source>Add corner</source>
        <translation>角を追加</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>角を削除</translation>
    </message>
    <message>
        <source>Corners of the building</source>
        <translation>建物の角</translation>
    </message>
    <message>
        <source>x, m</source>
        <translation>x (m)</translation>
    </message>
    <message>
        <source>y, m</source>
        <translation>y (m)</translation>
    </message>
    <message>
        <source>In the middle of the edge after the chosen corner</source>
        <translation>選んだ角の次の辺の中央に</translation>
    </message>
    <message>
        <source>“%1” is no number of metres on the map.</source>
        <translation>「%1」は地図上のメートル値ではありません。</translation>
    </message>
    <message>
        <source>The outline would cross itself, or have no area.</source>
        <translation>輪郭が自分自身と交差するか、面積がなくなります。</translation>
    </message>
</context>
<context>
    <name>handmap::WelcomeStrip</name>
    <message>
        <source>&lt;b&gt;Draw the map you remember&lt;/b&gt;; Handmap finds the robot on it and corrects the drawing.</source>
        <translation>&lt;b&gt;覚えている地図を描いてください。&lt;/b&gt;Handmap がその上でロボットの位置を見つけ、図面を補正します。</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>デモ</translation>
    </message>
    <message>
        <source>Watch a simulated robot correct a drawing</source>
        <translation>模擬ロボットが図面を補正する様子を見る</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>描く</translation>
    </message>
    <message>
        <source>Start with an empty drawing</source>
        <translation>空の図面から始める</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>What a real robot has seen</source>
        <translation>実際のロボットが見たもの</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>シミュレーター</translation>
    </message>
    <message>
        <source>A robot among buildings that you have a sketch of</source>
        <translation>スケッチのある建物の間を走るロボット</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Connect a live robot: camera or scanner, head, wheels</source>
        <translation>実機を接続: カメラまたはスキャナー、雲台、車輪</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>ツアー</translation>
    </message>
    <message>
        <source>Where things are, in five steps</source>
        <translation>五段階の画面案内</translation>
    </message>
    <message>
        <source>Do not show this again</source>
        <translation>今後表示しない</translation>
    </message>
</context>
<context>
    <name>handmap::WhyPanel</name>
    <message>
        <source>Building that is asked about</source>
        <translation>調べている建物</translation>
    </message>
    <message>
        <source>Wall that is asked about</source>
        <translation>調べている壁</translation>
    </message>
    <message>
        <source>Time
(s)</source>
        <translation>時刻
(秒)</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>光線</translation>
    </message>
    <message>
        <source>Saw at
(m)</source>
        <translation>見た位置
(m)</translation>
    </message>
    <message>
        <source>Weight
(%)</source>
        <translation>重み
(%)</translation>
    </message>
    <message>
        <source>Pulled
(m)</source>
        <translation>引いた量
(m)</translation>
    </message>
    <message>
        <source>Observations that placed the wall</source>
        <translation>壁の位置を決めた観測</translation>
    </message>
    <message>
        <source>Metres outwards from where the wall stands now. Click: look at that moment.</source>
        <translation>現在の壁から外向きのメートル。クリック: その時点を見る。</translation>
    </message>
    <message>
        <source>Click a corrected wall on the map, or choose one here: what placed it?</source>
        <translation>地図上の補正した壁をクリックするか、ここで選ぶと、その位置を決めたものがわかります。</translation>
    </message>
    <message>
        <source>%1 wall, %2 m long</source>
        <translation>%1の壁、%2 m</translation>
    </message>
    <message>
        <source>It stands %1 m %2 of the drawn one; known to ±%3 m.</source>
        <translation>描いた壁より %1 m %2にあります (±%3 m)。</translation>
    </message>
    <message>
        <source>inwards</source>
        <translation>内側</translation>
    </message>
    <message>
        <source>outwards</source>
        <translation>外側</translation>
    </message>
    <message>
        <source>Nobody saw it: its other walls put it there.</source>
        <translation>誰も見ていません。他の壁から決まりました。</translation>
    </message>
    <message>
        <source>Drawing: %1 ±%2 m, weight %3 %.</source>
        <translation>図面: %1 ±%2 m、重み %3 %。</translation>
    </message>
    <message>
        <source>What the robot saw is not kept: nothing more can be told.</source>
        <translation>ロボットが見たものは残されていません。これ以上はわかりません。</translation>
    </message>
    <message>
        <source>No ray ended within %1 m of it.</source>
        <translation>%1 m 以内で終わった光線はありません。</translation>
    </message>
    <message numerus="yes">
        <source>Seen: %1 ±%2 m, weight %3 %, by %n observation(s)</source>
        <translation>
            <numerusform>観測: %1 ±%2 m、重み %3 %、観測 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source> with %1 rays that ended within %2 m.</source>
        <translation> (%2 m 以内で終わった光線 %1 本)。</translation>
    </message>
    <message>
        <source>Together: %1 m. The rest is of its other walls and of the drawing as a whole.</source>
        <translation>合計: %1 m。残りは他の壁と図面全体によるものです。</translation>
    </message>
    <message>
        <source>Hardly a ray ended on it: its other walls put it there.</source>
        <translation>届いた光線がほとんどありません。他の壁がその位置を決めています。</translation>
    </message>
</context>
<context>
    <name>handmap::Words</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 to %2 m</source>
        <translation>%1 から %2 m</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>上</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>左下</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>下</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>Sure to %1 m; heading to %2°</source>
        <translation>確か: %1 m 以内、向き %2° 以内</translation>
    </message>
    <message>
        <source>Roughly here: within %1 m; heading to %2°</source>
        <translation>だいたいここ: %1 m 以内、向き %2° 以内</translation>
    </message>
    <message>
        <source>Lost: may be anywhere within %1 m</source>
        <translation>見失いました: %1 m 以内のどこか</translation>
    </message>
    <message>
        <source>at x %1 m, y %2 m</source>
        <translation>x %1 m、y %2 m</translation>
    </message>
    <message>
        <source>%1 m from %2</source>
        <translation>%2 から %1 m</translation>
    </message>
    <message numerus="yes">
        <source>%n building(s) moved by %1</source>
        <translation>
            <numerusform>建物 %n 棟が %1 移動</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stand(s) as drawn</source>
        <translation>
            <numerusform>%n 棟は描いたまま</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n was (were) not recognised</source>
        <translation>
            <numerusform>%n 棟は認識されませんでした</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>.</source>
        <translation>。</translation>
    </message>
    <message numerus="yes">
        <source>%n is (are) doubtful: look at %1.</source>
        <translation>
            <numerusform>%n 棟が疑わしい: %1 を見てください。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m from where it truly is</source>
        <translation>真の場所から %1 m</translation>
    </message>
    <message>
        <source>Not recognised: it is shown where the drawing has it</source>
        <translation>認識されていません。図面の場所に示しています</translation>
    </message>
    <message numerus="yes">
        <source>For: seen in %n observation(s)</source>
        <translation>
            <numerusform>支持: %n 件の観測で見えた</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 ±%2 m</source>
        <translation>%1 ±%2 m</translation>
    </message>
    <message>
        <source>For: walls seen: %1</source>
        <translation>支持: 見えた壁: %1</translation>
    </message>
    <message>
        <source>Against: walls that nobody saw: %1</source>
        <translation>反対: 誰も見ていない壁: %1</translation>
    </message>
    <message>
        <source>Against: it moved %1 times as far as the drawing says that it may be off (%2 m)</source>
        <translation>反対: 図面の不確かさ (%2 m) の %1 倍動いた</translation>
    </message>
    <message>
        <source>; nothing of the drawing recognised for %1 m</source>
        <translation>、%1 m の間、図面のものが一つも認識されていません</translation>
    </message>
    <message numerus="yes">
        <source>%n turned by up to %1</source>
        <translation>
            <numerusform>%n 棟が最大 %1 回転</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n grown or shrunk by up to %1 m</source>
        <translation>
            <numerusform>%n 棟が最大 %1 m 伸縮</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %n (%1) only one side was seen: how deep that is, is as drawn.</source>
        <translation>
            <numerusform>%n 棟 (%1) は一面だけ見えました。奥行きは図面のままです。</numerusform>
        </translation>
    </message>
    <message>
        <source>moved by %1 m</source>
        <translation>%1 m 移動</translation>
    </message>
    <message>
        <source>turned by %1</source>
        <translation>%1 回転</translation>
    </message>
    <message>
        <source>grown by %1 m</source>
        <translation>%1 m 拡大</translation>
    </message>
    <message>
        <source>shrunk by %1 m</source>
        <translation>%1 m 縮小</translation>
    </message>
    <message>
        <source>%1 stands in %2: they overlap by %3 % more than drawn</source>
        <translation>%1 が %2 に重なっている: 図面より %3 % 多く重なっています</translation>
    </message>
    <message>
        <source>%1 moved by %2 m: something else may have been taken for it</source>
        <translation>%1 が %2 m 移動。別のものと取り違えたかもしれません</translation>
    </message>
    <message>
        <source>%1 grew by %2 m: something else may have been taken for it</source>
        <translation>%1 が %2 m 拡大。別のものと取り違えたかもしれません</translation>
    </message>
    <message>
        <source>%1 shrank by %2 m: something else may have been taken for it</source>
        <translation>%1 が %2 m 縮小。別のものと取り違えたかもしれません</translation>
    </message>
    <message>
        <source>the robot came by and did not recognise it</source>
        <translation>ロボットがそばを通りましたが、この建物を認識しませんでした</translation>
    </message>
    <message>
        <source>what was seen may as well be another building</source>
        <translation>見えたものは別の建物かもしれません</translation>
    </message>
    <message>
        <source>Doubtful: %1. Of 100 buildings with such signs about %2 were wrong.</source>
        <translation>疑わしい: %1。このような兆候の建物 100 棟のうち、約 %2 棟が誤りでした。</translation>
    </message>
    <message>
        <source>; </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Not recognised: it is shown where the drawing has it, %1 together with the buildings beside it</source>
        <translation>認識されていません。図面の位置から、周りの建物とともに %1 して示しています</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>図面のまま</translation>
    </message>
    <message>
        <source>Against the drawing: %1</source>
        <translation>図面に対して: %1</translation>
    </message>
    <message>
        <source>Only one side was seen: how deep it is, is as drawn</source>
        <translation>一面だけ見えました。奥行きは図面のままです</translation>
    </message>
    <message>
        <source>Unsure: nothing of the drawing recognised for %1 m; if it was right before, within %2 m</source>
        <translation>不確か: %1 m の間、図面のものが一つも認識されていません。それまでが正しければ %2 m 以内</translation>
    </message>
</context>
</TS>
