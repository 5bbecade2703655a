<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko_KR" sourcelanguage="en_US">
    <context>
    <name>BoringTexts</name>
        <message>
            <source>top</source>
            <comment>depth of a bore</comment>
            <translation>위</translation>
        </message>
        <message>
            <source>middle</source>
            <comment>depth of a bore</comment>
            <translation>가운데</translation>
        </message>
        <message>
            <source>bottom</source>
            <comment>depth of a bore</comment>
            <translation>아래</translation>
        </message>
        <message>
            <source>part %1, %2</source>
            <comment>part number, depth of its bore</comment>
            <translation>%1번 공작물, %2</translation>
        </message>
        <message>
            <source>Tool reground</source>
            <translation>공구 재연삭</translation>
        </message>
        <message>
            <source>Other material</source>
            <translation>다른 소재</translation>
        </message>
        <message>
            <source>New insert</source>
            <translation>새 인서트</translation>
        </message>
        <message>
            <source>Below %1: %2.</source>
            <translation>%1 미만: %2.</translation>
        </message>
        <message>
            <source>Above %1: %2.</source>
            <translation>%1 초과: %2.</translation>
        </message>
    </context>
    <context>
    <name>FigureLimits</name>
        <message>
            <source>Limits: %1</source>
            <translation>한계: %1</translation>
        </message>
        <message>
            <source>Limits in the recipe of %1 (%2)</source>
            <translation>%1 레시피의 한계 (%2)</translation>
        </message>
        <message>
            <source>A figure outside its limits makes the part scrap. In the stored unit; an empty field is no limit. They hold for the parts to come: a part keeps the limits it was made under.</source>
            <translation>한계를 벗어난 값이 있으면 공작물은 불량입니다. 저장 단위로 입력하며 빈 칸은 한계 없음입니다. 앞으로 만들 공작물에 적용되며, 이미 만든 공작물은 만들 때의 한계를 유지합니다.</translation>
        </message>
        <message>
            <source>Figure</source>
            <translation>수치</translation>
        </message>
        <message>
            <source>Lower limit</source>
            <translation>하한</translation>
        </message>
        <message>
            <source>Upper limit</source>
            <translation>상한</translation>
        </message>
        <message>
            <source>Reason for the change</source>
            <translation>변경 사유</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>A limit is a number, or empty.</source>
            <translation>한계는 숫자이거나 비워 둡니다.</translation>
        </message>
        <message>
            <source>The limits stand in the recipe and hold for the parts to come.</source>
            <translation>한계를 레시피에 저장했으며 앞으로 만들 공작물에 적용됩니다.</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>저장</translation>
        </message>
        <message>
            <source>Limits of the parts</source>
            <translation>공작물 한계</translation>
        </message>
    </context>
    <context>
    <name>FirstEngineer</name>
        <message>
            <source>The first process engineer</source>
            <translation>첫 공정 엔지니어</translation>
        </message>
        <message>
            <source>This machine knows nobody yet who may change recipes, limits and roles. Until then everybody who signs on is an operator.</source>
            <translation>이 기계에는 레시피·한계·역할을 바꿀 수 있는 사람이 아직 없습니다. 그때까지 로그인하는 사람은 모두 작업자입니다.</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>이름</translation>
        </message>
        <message>
            <source>PIN, %1 to %2 digits</source>
            <translation>PIN, 숫자 %1~%2자리</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>나중에</translation>
        </message>
        <message>
            <source>A name and a PIN of %1 to %2 digits are needed.</source>
            <translation>이름과 숫자 %1~%2자리의 PIN이 필요합니다.</translation>
        </message>
        <message>
            <source>Make and sign on</source>
            <translation>만들고 로그인</translation>
        </message>
    </context>
    <context>
    <name>ForceText</name>
        <message>
            <source>zero being taken</source>
            <translation>영점 잡는 중</translation>
        </message>
        <message>
            <source>zero %1</source>
            <translation>영점 %1</translation>
        </message>
        <message>
            <source>no zero</source>
            <translation>영점 없음</translation>
        </message>
        <message>
            <source>zero doubtful by %1</source>
            <translation>영점 의심 ±%1</translation>
        </message>
        <message>
            <source>bandwidth %1</source>
            <translation>대역폭 %1</translation>
        </message>
        <message>
            <source>bandwidth not stated</source>
            <translation>대역폭 알 수 없음</translation>
        </message>
    </context>
    <context>
    <name>Help</name>
        <message>
            <source>HOLD ALL</source>
            <translation>전체 홀드</translation>
        </message>
        <message>
            <source>Takes every loop off within one cycle: the last offset stays, the feed is at or below the programmed one. The machine goes on. It is no emergency stop.</source>
            <translation>한 주기 안에 모든 제어를 뗍니다. 마지막 보정은 그대로 있고, 이송은 프로그램 값을 넘지 않습니다. 기계는 계속 움직이며, 비상 정지가 아닙니다.</translation>
        </message>
        <message>
            <source>Bottom line</source>
            <translation>아래 줄</translation>
        </message>
        <message>
            <source>The first alarm that nobody has seen yet. Show opens the page with its cause, what follows from it and what to do. A sentence about the last touch stands here for ten seconds.</source>
            <translation>아직 아무도 확인하지 않은 첫 알람입니다. 보기를 누르면 원인과 결과, 할 일이 나옵니다. 방금 누른 것에 대한 문장은 10초 동안 여기 나옵니다.</translation>
        </message>
        <message>
            <source>Machine strip</source>
            <translation>기계 상태 띠</translation>
        </message>
        <message>
            <source>What the machine does now: program, spindle speed, feed, the knob at the control, cutting force, parts with this tool, time to go. Grey is a figure that is not fresh. Touch the strip for tools and their life.</source>
            <translation>지금 기계가 하는 일입니다: 프로그램, 주축 회전수, 이송, 이송 오버라이드, 절삭력, 이 공구로 가공한 개수, 남은 시간. 회색은 최신 값이 아닙니다. 띠를 누르면 공구와 수명이 나옵니다.</translation>
        </message>
        <message>
            <source>Header</source>
            <translation>머리글</translation>
        </message>
        <message>
            <source>Machine, part type, lot and part; whether the machine is connected; who is signed on; language and settings.</source>
            <translation>기계, 품종, 로트와 공작물, 연결 상태, 로그인한 사람, 언어와 설정입니다.</translation>
        </message>
        <message>
            <source>Overview</source>
            <translation>전체 보기</translation>
        </message>
        <message>
            <source>One card for each loop of this machine: its lamp, one sentence, the figure that matters and its course. Made to be read from three metres; touch a card for its page.</source>
            <translation>이 기계의 제어마다 카드 하나: 상태등, 한 문장, 가장 중요한 값과 그 추이입니다. 3 m에서 읽도록 만들었으며, 카드를 누르면 그 페이지가 열립니다.</translation>
        </message>
        <message>
            <source>Boring</source>
            <translation>보링</translation>
        </message>
        <message>
            <source>Each bore that is measured teaches how this tool bends. From that the feed along the next bore is chosen so that it comes out at the target at every depth.</source>
            <translation>측정한 내경마다 이 공구가 얼마나 휘는지 배웁니다. 그것으로 다음 내경의 이송을 정해, 모든 깊이에서 목표 지름이 나오게 합니다.</translation>
        </message>
        <message>
            <source>Bores against the tolerance</source>
            <translation>공차와 내경</translation>
        </message>
        <message>
            <source>Measured diameters of the last 25 parts, one curve for each depth, between the limits of the recipe. The diamond with its bar is what the next part should become. A cross is a bore outside its limits.</source>
            <translation>최근 공작물 25개의 측정 지름이며, 깊이마다 곡선 하나씩 레시피의 한계 사이에 그립니다. 막대가 달린 마름모는 다음 공작물의 예상값입니다. 가위표는 한계를 벗어난 내경입니다.</translation>
        </message>
        <message>
            <source>Feed along the bore</source>
            <translation>내경을 따른 이송</translation>
        </message>
        <message>
            <source>The schedule of the part in the machine (dashed), what is really cut, and the part before in grey. Deeper the bar bends more, so the feed falls.</source>
            <translation>기계 안 공작물의 이송 계획(점선)과 실제 이송, 회색은 직전 공작물입니다. 깊을수록 바가 더 휘므로 이송이 줄어듭니다.</translation>
        </message>
        <message>
            <source>Next part</source>
            <translation>다음 공작물</translation>
        </message>
        <message>
            <source>Diameters to be expected with the schedule shown, with their 95 % interval, and why the schedule has changed. Under control it is used by itself; advising, a person accepts it.</source>
            <translation>표시한 계획으로 예상되는 지름과 95 % 구간, 그리고 계획이 바뀐 이유입니다. 제어 중에는 저절로 쓰이고, 추천 중에는 사람이 수락합니다.</translation>
        </message>
        <message>
            <source>What has been learnt</source>
            <translation>학습한 것</translation>
        </message>
        <message>
            <source>The three constants of the law of bending and how sure they are. The band narrows with every bore; a jump means another insert, tool or material.</source>
            <translation>휨 법칙의 세 상수와 그 확실함입니다. 내경을 잴 때마다 띠가 좁아지며, 갑자기 뛰면 인서트나 공구, 소재가 바뀐 것입니다.</translation>
        </message>
        <message>
            <source>Entering a bore</source>
            <translation>내경 입력</translation>
        </message>
        <message>
            <source>The bore that waits for its diameter. Type the last two figures or the whole diameter and press Enter, press Gauge, or use a hand gauge. What is not plausible is asked about first.</source>
            <translation>측정 대기 중인 내경입니다. 마지막 두 자리나 지름 전체를 입력하고 Enter를 누르거나, 게이지 버튼 또는 손 게이지를 쓰십시오. 그럴듯하지 않은 값은 먼저 되묻습니다.</translation>
        </message>
        <message>
            <source>Milling</source>
            <translation>밀링</translation>
        </message>
        <message>
            <source>The feed follows the cutting force: where the blank has more stock it slows down, where it has less it hurries. The force stays even, so the wall bends evenly.</source>
            <translation>이송이 절삭력을 따릅니다. 소재 여유가 많으면 늦추고 적으면 높입니다. 절삭력이 고르므로 벽도 고르게 휩니다.</translation>
        </message>
        <message>
            <source>Force and feed</source>
            <translation>절삭력과 이송</translation>
        </message>
        <message>
            <source>The force averaged over a revolution against its reference (dashed) and the overload limit; below, the feed that is really made.</source>
            <translation>한 회전 평균 절삭력과 기준값(점선), 과부하 한계이며, 아래는 실제 이송입니다.</translation>
        </message>
        <message>
            <source>Wall deviation</source>
            <translation>벽 편차</translation>
        </message>
        <message>
            <source>How far the wall stands from its place along the path, as the force tells it. Waviness is what is left when the mean is taken off.</source>
            <translation>절삭력으로 본, 경로를 따른 벽의 벗어남입니다. 굴곡은 평균을 뺀 나머지입니다.</translation>
        </message>
        <message>
            <source>Tool and wear</source>
            <translation>공구와 마모</translation>
        </message>
        <message>
            <source>The cutting stiffness of each part since the tool was new. Wear makes it rise; at the line it is announced.</source>
            <translation>공구가 새것일 때부터 공작물마다의 절삭 강성입니다. 마모되면 올라가며, 선에 닿으면 알립니다.</translation>
        </message>
        <message>
            <source>Milling control</source>
            <translation>밀링 제어</translation>
        </message>
        <message>
            <source>Off, advise or control. Advising, the cut is made at the planned feed and the page says what control would have done, and what it would have saved.</source>
            <translation>꺼짐, 추천, 제어입니다. 추천 중에는 계획 이송으로 가공하며, 제어했다면 무엇을 했고 얼마나 절약했을지 말해 줍니다.</translation>
        </message>
        <message>
            <source>Turning</source>
            <translation>선삭</translation>
        </message>
        <message>
            <source>The cutting force shows how deep the tool really is. A fast trim moves the tool against the disturbance, so the face becomes flatter than the machine alone makes it.</source>
            <translation>절삭력이 공구의 실제 깊이를 보여 줍니다. 빠른 보정이 외란에 맞서 공구를 움직여, 기계만으로 깎을 때보다 면이 평평해집니다.</translation>
        </message>
        <message>
            <source>Spectrum</source>
            <translation>스펙트럼</translation>
        </message>
        <message>
            <source>What the disturbance consists of. A named line is a frequency that the law has found and cancels, or would cancel.</source>
            <translation>외란이 무엇으로 이루어졌는지 보여 줍니다. 이름이 붙은 선은 찾아낸 주파수이며, 상쇄하거나 상쇄할 대상입니다.</translation>
        </message>
        <message>
            <source>Margins</source>
            <translation>여유</translation>
        </message>
        <message>
            <source>How much the loop may be wrong about the process before it begins to ring: gain, phase, delay. Below the line the law is made milder.</source>
            <translation>공정을 얼마나 잘못 알아도 떨기 시작하지 않는지 보여 줍니다: 게인, 위상, 지연. 선 아래로 내려가면 법칙을 부드럽게 합니다.</translation>
        </message>
        <message>
            <source>Surface</source>
            <translation>표면</translation>
        </message>
        <message>
            <source>The surface as it is predicted: with the trim, and what it would be without. Root mean square and peak to valley of the last whole revolution.</source>
            <translation>예측한 표면입니다: 보정이 있을 때와 없을 때. 제곱평균제곱근과, 마지막 한 회전의 최고 최저 차이입니다.</translation>
        </message>
        <message>
            <source>Thermal</source>
            <translation>열변위</translation>
        </message>
        <message>
            <source>A warm machine grows, and the work origin moves. From the temperatures the model says how far, and the origin is shifted back.</source>
            <translation>기계가 더워지면 늘어나 공작물 원점이 움직입니다. 모델이 온도로 그 거리를 말하고, 원점을 되돌립니다.</translation>
        </message>
        <message>
            <source>Drift of the origin</source>
            <translation>원점 열변위</translation>
        </message>
        <message>
            <source>How far the origin has gone in each axis since the temperatures to count from were taken, and the interval in which it is with 95 %. Wider than the part allows: measure.</source>
            <translation>기준 온도를 잡은 뒤 축마다 원점이 움직인 거리와 95 % 구간입니다. 공작물이 허용하는 것보다 넓으면 측정하십시오.</translation>
        </message>
        <message>
            <source>Thermocouples</source>
            <translation>열전대</translation>
        </message>
        <message>
            <source>Where each one sits and what it reads. One that does not agree with its neighbours is left out and named; the interval becomes wider.</source>
            <translation>각각의 위치와 온도입니다. 이웃과 맞지 않는 것은 빼고 이름을 말하며, 구간이 넓어집니다.</translation>
        </message>
        <message>
            <source>Tapping</source>
            <translation>탭 가공</translation>
        </message>
        <message>
            <source>Spindle and Z must keep step, or the thread is cut too wide. Kerf tries gains in the air, proposes better ones, and learns a trim from tap to tap.</source>
            <translation>주축과 Z가 걸음을 맞춰야 나사가 헐거워지지 않습니다. Kerf가 에어 탭으로 게인을 시험해 더 나은 값을 제안하고, 탭마다 보정을 배웁니다.</translation>
        </message>
        <message>
            <source>Error along the thread</source>
            <translation>나사를 따른 오차</translation>
        </message>
        <message>
            <source>How far Z is from where the spindle says it should be, over the revolutions in and out, in the band of the thread's class. Now against the first tap.</source>
            <translation>들어가고 나오는 회전에 따라, 주축이 말하는 위치에서 Z가 벗어난 거리이며 나사 등급의 띠 안에 그립니다. 지금과 첫 탭을 비교합니다.</translation>
        </message>
        <message>
            <source>Gains</source>
            <translation>게인</translation>
        </message>
        <message>
            <source>The drive's gains now, the next that are proposed, and the range that was found safe in the air. Nothing outside of it is ever tried.</source>
            <translation>지금 드라이브의 게인, 다음 제안, 그리고 공중에서 안전하다고 확인한 범위입니다. 그 밖은 시험하지 않습니다.</translation>
        </message>
        <message>
            <source>What can be done</source>
            <translation>할 수 있는 일</translation>
        </message>
        <message>
            <source>An air tap touches nothing. A tuning tries some gains and keeps the best. A tap that stands in the hole is turned out in sync from here, never jogged.</source>
            <translation>에어 탭은 아무것에도 닿지 않습니다. 튜닝은 게인을 몇 번 시험해 가장 좋은 것을 남깁니다. 구멍에 멈춘 탭은 여기서 동기로 돌려 뺍니다. 절대 조그로 빼지 마십시오.</translation>
        </message>
        <message>
            <source>Quality</source>
            <translation>품질</translation>
        </message>
        <message>
            <source>Whether the process is in control, and what drives it. Signals are about the error against the law's prediction: the raw diameter is moved by the controller itself.</source>
            <translation>공정이 관리 상태인지, 무엇이 움직이는지 보여 줍니다. 신호는 법칙의 예측에 대한 오차로 봅니다. 지름 자체는 제어기가 움직이기 때문입니다.</translation>
        </message>
        <message>
            <source>Indices</source>
            <translation>지수</translation>
        </message>
        <message>
            <source>How well the lot fits its tolerance. They are shown only where the whole lot is steady: an index of a process that moves says nothing.</source>
            <translation>로트가 공차에 얼마나 잘 맞는지입니다. 로트 전체가 안정할 때만 보여 줍니다. 움직이는 공정의 지수는 아무 뜻이 없습니다.</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>Every part of every process, newest first, with its figures and its verdict. Search by serial number, lot or part type; touch a row for its details, report and corrections.</source>
            <translation>모든 공정의 모든 공작물을 최신순으로 값과 판정과 함께 보여 줍니다. 일련번호나 로트, 품종으로 찾고, 줄을 누르면 상세와 보고서, 정정이 나옵니다.</translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>근무조</translation>
        </message>
        <message>
            <source>What is stored between two handovers: parts with verdicts, pauses longer than three minutes and why, changes with names, alarms and notes. Handing over signs it and begins the next shift.</source>
            <translation>두 인계 사이에 저장된 것입니다: 판정별 공작물, 3분을 넘는 정지와 사유, 이름이 남은 변경, 알람과 메모. 인계하면 서명되고 다음 근무조가 시작됩니다.</translation>
        </message>
        <message>
            <source>What was saved</source>
            <translation>절약한 것</translation>
        </message>
        <message>
            <source>Milled parts: the time at the planned feed less the time really cut. Bores: how many are inside their tolerance that would be outside with the recipe's first feed, by the bending found at that time.</source>
            <translation>밀링: 계획 이송의 시간에서 실제 절삭 시간을 뺀 것입니다. 내경: 그때 알아낸 휨으로 볼 때, 레시피의 첫 이송이었다면 공차를 벗어났을 내경의 개수입니다.</translation>
        </message>
        <message>
            <source>Sensors</source>
            <translation>센서</translation>
        </message>
        <message>
            <source>What is connected, what it reads, how old that is and where it sits. “Which one rises?”: hold a finger on a sensor and see which channel it is.</source>
            <translation>무엇이 연결되어 있고, 값과 그 나이, 위치를 보여 줍니다. 센서에 손가락을 대면 어느 채널인지 알 수 있습니다.</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>알람</translation>
        </message>
        <message>
            <source>Each alarm with its cause, what follows from it and what to do. Seen takes it off the bottom line; it stays here until it is gone, then in the history.</source>
            <translation>알람마다 원인과 결과, 할 일이 있습니다. 확인하면 아래 줄에서 사라지고, 없어질 때까지 여기에, 그 뒤에는 이력에 남습니다.</translation>
        </message>
        <message>
            <source>Diagnostics</source>
            <translation>진단</translation>
        </message>
        <message>
            <source>How punctual the engine is, how long a cycle takes, the version, the data file and its backup. For whoever looks after Kerf.</source>
            <translation>엔진이 얼마나 정시에 도는지, 주기가 얼마나 걸리는지, 버전과 데이터 파일, 백업입니다. Kerf를 관리하는 사람을 위한 페이지입니다.</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>끄기</translation>
        </message>
        <message>
            <source>The loop has no influence: the machine runs as it was programmed. What is measured is still kept.</source>
            <translation>루프가 아무 영향도 주지 않고 기계는 프로그램대로 움직입니다. 측정한 값은 그대로 저장됩니다.</translation>
        </message>
        <message>
            <source>Advise</source>
            <translation>추천</translation>
        </message>
        <message>
            <source>The loop computes and shows what it would do, and does nothing. The way to get to know it.</source>
            <translation>루프는 계산하고 보여 주기만 하며 아무것도 하지 않습니다. 루프를 익히기 좋은 방법입니다.</translation>
        </message>
        <message>
            <source>Control</source>
            <translation>제어</translation>
        </message>
        <message>
            <source>The loop acts on the machine, within its limits. HOLD ALL takes it off at once.</source>
            <translation>루프가 한계 안에서 기계에 작용합니다. 전체 홀드를 누르면 바로 멈춥니다.</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>시작</translation>
        </message>
        <message>
            <source>Starts the program of the next part, where the control allows it. Off, it says what is missing.</source>
            <translation>제어기가 허용하면 다음 공작물의 프로그램을 시작합니다. 꺼져 있으면 무엇이 부족한지 나옵니다.</translation>
        </message>
        <message>
            <source>Start part</source>
            <translation>공작물 시작</translation>
        </message>
        <message>
            <source>Starts the next part on the simulator, or on a control that allows it. Off, it says why.</source>
            <translation>시뮬레이터나 허용하는 제어기에서 다음 공작물을 시작합니다. 꺼져 있으면 이유가 나옵니다.</translation>
        </message>
        <message>
            <source>Release hold</source>
            <translation>홀드 해제</translation>
        </message>
        <message>
            <source>After a look at the machine: the loops go on in the mode they had, without a jump. A stop stays until it is released by its own button.</source>
            <translation>기계를 살펴본 뒤 누르면 루프가 전의 모드로 튀지 않고 이어집니다. 정지는 자기 단추로 풀 때까지 남습니다.</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>이송</translation>
        </message>
        <message>
            <source>How fast the axis moves now, as the control reports it. Grey: not fresh.</source>
            <translation>제어기가 알려 주는 지금의 축 이송 속도입니다. 회색이면 새 값이 아닙니다.</translation>
        </message>
        <message>
            <source>Parts since start</source>
            <translation>시작 이후 공작물</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>수락</translation>
        </message>
        <message>
            <source>In advise mode: the schedule shown is what the next part shall be cut with. It is written down with the name. In control every schedule is used by itself. Its bores are expected within the 95 % interval shown.</source>
            <translation>추천 모드에서 표시한 계획으로 다음 공작물을 가공합니다. 이름과 함께 기록됩니다. 제어 중에는 저절로 쓰입니다. 내경은 표시한 95 % 구간 안에 들 것으로 예상됩니다.</translation>
        </message>
        <message>
            <source>Tool or material changed</source>
            <translation>공구 또는 소재 변경</translation>
        </message>
        <message>
            <source>Two touches after a new insert, a reground tool or another batch of material: the next bore is expected from what such changes have brought before, with a wider interval.</source>
            <translation>새 인서트, 재연삭한 공구, 다른 소재 묶음이면 두 번만 누르십시오. 그런 변경이 전에 가져온 결과에서 다음 내경을 예상하고 구간은 더 넓어집니다.</translation>
        </message>
        <message>
            <source>Next lot</source>
            <translation>다음 로트</translation>
        </message>
        <message>
            <source>This lot is complete or closed: here the next one is opened.</source>
            <translation>이 로트가 끝났거나 닫혔습니다. 여기서 다음 로트를 엽니다.</translation>
        </message>
        <message>
            <source>Undo last</source>
            <translation>직전 입력 취소</translation>
        </message>
        <message>
            <source>Takes the newest diameter back. It stays in the records, with who undid it.</source>
            <translation>가장 새로운 지름을 되돌립니다. 누가 취소했는지와 함께 기록에 남습니다.</translation>
        </message>
        <message>
            <source>Correct</source>
            <translation>수정</translation>
        </message>
        <message>
            <source>All diameters of the lot: touch one to correct it or take it out, with a reason. Everything after it is computed again.</source>
            <translation>로트의 모든 지름입니다. 하나를 눌러 사유와 함께 수정하거나 뺍니다. 그 뒤의 것은 모두 다시 계산됩니다.</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>게이지</translation>
        </message>
        <message>
            <source>On the simulator: measures the bore that waits. On a machine the gauge sends by its own key.</source>
            <translation>시뮬레이터에서는 기다리는 내경을 측정합니다. 실제 기계에서는 게이지의 키로 보냅니다.</translation>
        </message>
        <message>
            <source>Measure again</source>
            <translation>다시 측정</translation>
        </message>
        <message>
            <source>Leaves the value that was asked about and waits for another one. Nothing was stored.</source>
            <translation>물어본 값을 버리고 다른 값을 기다립니다. 아무것도 저장되지 않았습니다.</translation>
        </message>
        <message>
            <source>Confirm</source>
            <translation>확인</translation>
        </message>
        <message>
            <source>The value is far from what was expected, and it is right: it is stored as confirmed.</source>
            <translation>예상과 크게 다르지만 맞는 값입니다. 확인한 값으로 저장합니다.</translation>
        </message>
        <message>
            <source>Channels</source>
            <translation>채널</translation>
        </message>
        <message>
            <source>Which channel of the gauge box stands for which depth. Learnt once, changed here.</source>
            <translation>게이지 상자의 어느 채널이 어느 깊이인지 정합니다. 한 번 익히고 여기서 바꿉니다.</translation>
        </message>
        <message>
            <source>Expected diameter</source>
            <translation>예상 지름</translation>
        </message>
        <message>
            <source>What the next part is expected to measure at this depth. 19 of 20 bores fall into the interval beside it.</source>
            <translation>이 깊이에서 다음 공작물이 가질 것으로 예상되는 값입니다. 내경 20개 가운데 19개가 옆의 구간에 듭니다.</translation>
        </message>
        <message>
            <source>Force</source>
            <translation>절삭력</translation>
        </message>
        <message>
            <source>Mean force of the last revolution; this is what is held.</source>
            <translation>마지막 한 회전의 평균 절삭력이며 이 값을 일정하게 유지합니다.</translation>
        </message>
        <message>
            <source>Force of single teeth</source>
            <translation>날 하나의 절삭력</translation>
        </message>
        <message>
            <source>Lowest and highest force since the last picture: what the tool really feels.</source>
            <translation>지난 화면 이후 가장 작은 힘과 가장 큰 힘으로, 공구가 실제로 받는 힘입니다.</translation>
        </message>
        <message>
            <source>Feed now; under control it goes where the force wants it.</source>
            <translation>지금의 이송입니다. 제어 중에는 절삭력에 맞추어 변합니다.</translation>
        </message>
        <message>
            <source>How the tool cuts</source>
            <translation>공구의 절삭 상태</translation>
        </message>
        <message>
            <source>How hard this tool works for its feed, as learnt from its cuts. It grows as the tool wears.</source>
            <translation>이 공구가 이송에 비해 얼마나 힘들게 깎는지를 절삭에서 학습한 값입니다. 공구가 닳을수록 커집니다.</translation>
        </message>
        <message>
            <source>New tool</source>
            <translation>새 공구</translation>
        </message>
        <message>
            <source>Another tool is in: wear is counted anew, and what tools of its kind have taught is used.</source>
            <translation>다른 공구를 끼웠습니다. 마모를 새로 세고 같은 종류의 공구에서 배운 것을 씁니다.</translation>
        </message>
        <message>
            <source>Teach</source>
            <translation>가르치기</translation>
        </message>
        <message>
            <source>Takes the mean force of the last good cut as the reference that the feed shall hold.</source>
            <translation>이번 절삭이나 마지막 절삭의 평균 절삭력을 이송이 유지할 기준으로 삼습니다.</translation>
        </message>
        <message>
            <source>Release the stop</source>
            <translation>정지 해제</translation>
        </message>
        <message>
            <source>The feed was stopped by an overload or a broken tool. After a look at tool and work, this lets the next cut begin; it needs a name.</source>
            <translation>과부하나 공구 파손으로 이송이 멈췄습니다. 공구와 공작물을 살펴본 뒤 다음 절삭을 허용하며 이름이 필요합니다.</translation>
        </message>
        <message>
            <source>Reference force</source>
            <translation>기준 절삭력</translation>
        </message>
        <message>
            <source>The force that the feed holds: higher is faster, and bends the tool more.</source>
            <translation>이송이 유지하는 절삭력입니다. 높을수록 빠르지만 공구가 더 휩니다.</translation>
        </message>
        <message>
            <source>Peak force</source>
            <translation>최대 절삭력</translation>
        </message>
        <message>
            <source>Highest force of this cut, of single teeth.</source>
            <translation>이번 절삭에서 날 하나가 받은 가장 큰 힘입니다.</translation>
        </message>
        <message>
            <source>Saved</source>
            <translation>절약</translation>
        </message>
        <message>
            <source>Time against the planned feed on the same path; in advise mode, what control would save.</source>
            <translation>같은 경로를 계획 이송으로 갈 때와의 시간 차이입니다. 추천 모드에서는 제어했다면 아꼈을 시간입니다.</translation>
        </message>
        <message>
            <source>Law</source>
            <translation>법칙</translation>
        </message>
        <message>
            <source>How the feed is found from the force. Model is the default; the others are there to compare.</source>
            <translation>절삭력에서 이송을 구하는 방법입니다. 모델이 기본이고 나머지는 비교용입니다.</translation>
        </message>
        <message>
            <source>Setup</source>
            <translation>설정</translation>
        </message>
        <message>
            <source>Tool, path, planned feed, reference and limits of the next cuts.</source>
            <translation>공구, 경로, 계획 이송, 기준과 다음 절삭의 한계입니다.</translation>
        </message>
        <message>
            <source>Blank</source>
            <translation>소재 형상</translation>
        </message>
        <message>
            <source>How much stands on the blank along the path, so that the feed is ready before a step comes.</source>
            <translation>경로를 따라 소재가 얼마나 서 있는지입니다. 단차가 오기 전에 이송을 준비합니다.</translation>
        </message>
        <message>
            <source>Log</source>
            <translation>기록</translation>
        </message>
        <message>
            <source>The last cuts with force, waviness and time.</source>
            <translation>마지막 절삭들의 힘, 파형과 시간입니다.</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>공구들</translation>
        </message>
        <message>
            <source>What was learnt of tools of this kind; one can be left out, with a reason.</source>
            <translation>이 종류의 공구에서 배운 것입니다. 사유를 적고 하나를 뺄 수 있습니다.</translation>
        </message>
        <message>
            <source>Depth, speed and path of the next cut, and how far the trim may go.</source>
            <translation>다음 가공의 깊이, 속도, 경로와 보정이 갈 수 있는 범위입니다.</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>열림</translation>
        </message>
        <message>
            <source>No trim: what the lathe does by itself.</source>
            <translation>보정하지 않은, 선반 그대로의 상태입니다.</translation>
        </message>
        <message>
            <source>Paper</source>
            <translation>논문</translation>
        </message>
        <message>
            <source>The controller of the published work, for comparison.</source>
            <translation>발표된 연구의 제어기로, 비교용입니다.</translation>
        </message>
        <message>
            <source>PI</source>
            <translation>PI</translation>
        </message>
        <message>
            <source>A tuned PI controller, for comparison.</source>
            <translation>조정한 PI 제어기로, 비교용입니다.</translation>
        </message>
        <message>
            <source>Tones</source>
            <translation>톤</translation>
        </message>
        <message>
            <source>The default: a broadband law, and one for each vibration it finds; none has to be named.</source>
            <translation>기본값입니다. 넓은 대역의 법칙과, 찾아낸 진동마다 하나씩 더합니다. 이름을 지정할 필요가 없습니다.</translation>
        </message>
        <message>
            <source>Tune</source>
            <translation>튜닝</translation>
        </message>
        <message>
            <source>Taps in the air, then proposes gains that match spindle and Z, and says what limits them.</source>
            <translation>공중에서 탭을 돌려 본 뒤 주축과 Z가 맞는 게인을 제안하고 무엇이 한계인지 알려 줍니다.</translation>
        </message>
        <message>
            <source>Turn out</source>
            <translation>되돌려 빼기</translation>
        </message>
        <message>
            <source>A tap stands in the hole: spindle and Z turn it out together.</source>
            <translation>탭이 구멍에 서 있습니다. 주축과 Z가 함께 돌려 뺍니다.</translation>
        </message>
        <message>
            <source>Job</source>
            <translation>작업</translation>
        </message>
        <message>
            <source>Thread, depth, speed and class of what is tapped.</source>
            <translation>탭 가공할 나사, 깊이, 속도와 등급입니다.</translation>
        </message>
        <message>
            <source>Tap</source>
            <translation>탭</translation>
        </message>
        <message>
            <source>One tap with the gains in force, in the work or in the air.</source>
            <translation>지금의 게인으로 공작물이나 공중에서 탭 한 번을 합니다.</translation>
        </message>
        <message>
            <source>One more</source>
            <translation>한 번 더</translation>
        </message>
        <message>
            <source>One more trial before the proposal is made.</source>
            <translation>제안하기 전에 시험을 한 번 더 합니다.</translation>
        </message>
        <message>
            <source>The gains proposed are used from now on, and kept with your name.</source>
            <translation>제안한 게인을 이제부터 쓰고 이름과 함께 보관합니다.</translation>
        </message>
        <message>
            <source>Roll back</source>
            <translation>되돌리기</translation>
        </message>
        <message>
            <source>Back to the gains that were in force before.</source>
            <translation>전에 쓰던 게인으로 돌아갑니다.</translation>
        </message>
        <message>
            <source>Abort</source>
            <translation>중단</translation>
        </message>
        <message>
            <source>Turns the tap out in step with Z and goes back to the gains accepted last.</source>
            <translation>Z와 맞추어 탭을 돌려 빼고 마지막에 수락한 게인으로 돌아갑니다.</translation>
        </message>
        <message>
            <source>Trials follow each other without a touch, until a proposal is there.</source>
            <translation>제안이 나올 때까지 누르지 않아도 시험이 이어집니다.</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>열변위</translation>
        </message>
        <message>
            <source>How far the origin is thought to have moved since the reference, with the interval in which it lies on 19 of 20 minutes. Measuring makes it narrow.</source>
            <translation>기준 이후 원점이 움직였다고 보는 양과, 20분 가운데 19분이 드는 구간입니다. 측정하면 좁아집니다.</translation>
        </message>
        <message>
            <source>Warm up</source>
            <translation>예열</translation>
        </message>
        <message>
            <source>Runs the warm-up program until the drift is small enough to cut.</source>
            <translation>가공할 만큼 열변위가 작아질 때까지 예열 프로그램을 돌립니다.</translation>
        </message>
        <message>
            <source>Measure</source>
            <translation>측정</translation>
        </message>
        <message>
            <source>Measures the origin: the prediction counts on from what was measured, at once.</source>
            <translation>원점을 측정합니다. 예측은 바로 측정한 값에서 이어집니다.</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>모델</translation>
        </message>
        <message>
            <source>Which days the model has learnt from, how well it told days it had not seen, train, go back.</source>
            <translation>모델이 어느 날들에서 배웠는지, 보지 못한 날을 얼마나 맞혔는지 보고, 학습시키거나 되돌립니다.</translation>
        </message>
        <message>
            <source>History</source>
            <translation>이력</translation>
        </message>
        <message>
            <source>Every shift of the origin, with when and why.</source>
            <translation>원점을 옮긴 모든 기록과 시각, 이유입니다.</translation>
        </message>
        <message>
            <source>Thermocouples: where each sits, and its health.</source>
            <translation>열전대가 어디에 있는지와 그 상태입니다.</translation>
        </message>
        <message>
            <source>Map</source>
            <translation>지도</translation>
        </message>
        <message>
            <source>How the error of the axes differs over the table.</source>
            <translation>축의 오차가 테이블 위에서 어떻게 다른지입니다.</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>한계</translation>
        </message>
        <message>
            <source>How far and how often the origin may be shifted.</source>
            <translation>원점을 얼마나 멀리, 얼마나 자주 옮길 수 있는지입니다.</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>위치</translation>
        </message>
        <message>
            <source>Touch the picture where this sensor sits.</source>
            <translation>이 센서가 있는 곳을 그림에서 누르십시오.</translation>
        </message>
        <message>
            <source>Acknowledge</source>
            <translation>확인</translation>
        </message>
        <message>
            <source>Somebody has seen this alarm; the name goes into the history. It stays until its cause is gone.</source>
            <translation>누군가 이 알람을 보았습니다. 이름이 이력에 남습니다. 원인이 사라질 때까지 알람은 남습니다.</translation>
        </message>
        <message>
            <source>Now</source>
            <translation>지금</translation>
        </message>
        <message>
            <source>Alarms that stand now, the most urgent first.</source>
            <translation>지금 서 있는 알람이며 급한 것이 먼저입니다.</translation>
        </message>
        <message>
            <source>All alarms, with when they came and went, and who has seen them.</source>
            <translation>모든 알람과 언제 왔다가 갔는지, 누가 보았는지입니다.</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>내보내기</translation>
        </message>
        <message>
            <source>The history as shown, as a table into a folder of your choice. No file is written over.</source>
            <translation>표시한 이력을 표로 만들어 고른 폴더에 넣습니다. 있는 파일은 덮어쓰지 않습니다.</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>찾기</translation>
        </message>
        <message>
            <source>Part number, serial number, lot or part type; what is typed is looked for as it is typed.</source>
            <translation>공작물 번호, 일련번호, 로트, 품종을 입력하는 대로 찾습니다.</translation>
        </message>
        <message>
            <source>Out of tolerance</source>
            <translation>공차 밖</translation>
        </message>
        <message>
            <source>Only parts with rework or scrap.</source>
            <translation>재가공이나 불량이 있는 공작물만 봅니다.</translation>
        </message>
        <message>
            <source>This lot</source>
            <translation>이 로트</translation>
        </message>
        <message>
            <source>Only parts of the lot that is open.</source>
            <translation>열려 있는 로트의 공작물만 봅니다.</translation>
        </message>
        <message>
            <source>The parts shown, as a table for Excel or programs, into a folder of your choice.</source>
            <translation>표시한 공작물을 엑셀이나 다른 프로그램용 표로 만들어 고른 폴더에 넣습니다.</translation>
        </message>
        <message>
            <source>Another value for the diameter chosen, with a reason. The old one stays in the records.</source>
            <translation>고른 지름을 사유와 함께 다른 값으로 바꿉니다. 옛 값은 기록에 남습니다.</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>빼기</translation>
        </message>
        <message>
            <source>The diameter chosen no longer counts, with a reason. It stays in the records.</source>
            <translation>고른 지름을 사유와 함께 세지 않습니다. 기록에는 남습니다.</translation>
        </message>
        <message>
            <source>Serial</source>
            <translation>일련번호</translation>
        </message>
        <message>
            <source>Gives the part its serial number, or another one.</source>
            <translation>공작물에 일련번호를 주거나 바꿉니다.</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>보고서</translation>
        </message>
        <message>
            <source>One page about this part as PDF: diameters, tolerance, verdict, feed.</source>
            <translation>이 공작물의 지름, 공차, 판정, 이송을 PDF 한 장으로 만듭니다.</translation>
        </message>
        <message>
            <source>What was done with parts outside their limits: reworked, scrapped, released by whom.</source>
            <translation>한계를 벗어난 공작물을 어떻게 했는지 적습니다. 재가공, 불량, 누가 허용했는지.</translation>
        </message>
        <message>
            <source>Files</source>
            <translation>파일</translation>
        </message>
        <message>
            <source>Reports of the lot, and Q-DAS files by hand or by themselves into a folder.</source>
            <translation>로트 보고서, 그리고 손으로 또는 저절로 폴더에 넣는 Q-DAS 파일입니다.</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>게이지들</translation>
        </message>
        <message>
            <source>The register of gauges: range, due date, studies of a ring and of several people.</source>
            <translation>게이지 등록부입니다. 범위, 기한, 링과 여러 사람의 평가가 있습니다.</translation>
        </message>
        <message>
            <source>Limits of the figures of milled, turned and tapped parts, by which they are judged.</source>
            <translation>밀링, 터닝, 탭 가공 수치의 한계이며 이것으로 판정합니다.</translation>
        </message>
        <message>
            <source>Older</source>
            <translation>이전</translation>
        </message>
        <message>
            <source>The parts before those shown.</source>
            <translation>표시한 것보다 앞의 공작물입니다.</translation>
        </message>
        <message>
            <source>Newer</source>
            <translation>다음</translation>
        </message>
        <message>
            <source>The parts after those shown.</source>
            <translation>표시한 것보다 뒤의 공작물입니다.</translation>
        </message>
        <message>
            <source>Leave a note</source>
            <translation>메모 남기기</translation>
        </message>
        <message>
            <source>A sentence for the next shift, signed with your name.</source>
            <translation>다음 근무조에 남기는 한 문장이며 이름이 붙습니다.</translation>
        </message>
        <message>
            <source>Hand over</source>
            <translation>인계</translation>
        </message>
        <message>
            <source>Signs this shift; the next one begins now and reads your words first.</source>
            <translation>이 근무조에 서명합니다. 다음 근무조가 지금 시작되고 이 글을 먼저 읽습니다.</translation>
        </message>
        <message>
            <source>One page (PDF)</source>
            <translation>한 장 보고서 (PDF)</translation>
        </message>
        <message>
            <source>The shift as it stands here, on one page.</source>
            <translation>지금 보이는 근무조를 한 장으로 만듭니다.</translation>
        </message>
        <message>
            <source>Shift before</source>
            <translation>이전 근무조</translation>
        </message>
        <message>
            <source>The shift that was handed over before the one shown.</source>
            <translation>표시한 것보다 앞서 인계된 근무조입니다.</translation>
        </message>
        <message>
            <source>This shift</source>
            <translation>이번 근무조</translation>
        </message>
        <message>
            <source>Back to the shift that goes on.</source>
            <translation>지금 이어지는 근무조로 돌아갑니다.</translation>
        </message>
        <message>
            <source>Stops</source>
            <translation>정지</translation>
        </message>
        <message>
            <source>Pauses of more than three minutes. Touch one and say why; two touches.</source>
            <translation>3분이 넘는 멈춤입니다. 하나를 눌러 사유를 고릅니다. 두 번이면 됩니다.</translation>
        </message>
        <message>
            <source>Which one rises?</source>
            <translation>어느 것이 오르는가?</translation>
        </message>
        <message>
            <source>Warm a thermocouple with a finger: the one that rises first is named, so that its place on the picture can be set.</source>
            <translation>손가락으로 열전대를 따뜻하게 하십시오. 먼저 오르는 것의 이름이 나와 그림에서 위치를 정할 수 있습니다.</translation>
        </message>
        <message>
            <source>Ask the gauge</source>
            <translation>게이지에 묻기</translation>
        </message>
        <message>
            <source>Asks a gauge for a reading, to see that it answers.</source>
            <translation>게이지가 답하는지 보려고 값을 한 번 묻습니다.</translation>
        </message>
        <message>
            <source>Back up all data</source>
            <translation>모든 데이터 백업</translation>
        </message>
        <message>
            <source>A checked copy of everything in one file, made while everything goes on.</source>
            <translation>모든 것이 이어지는 동안 검사한 사본을 파일 하나로 만듭니다.</translation>
        </message>
        <message>
            <source>Restore a backup</source>
            <translation>백업 복원</translation>
        </message>
        <message>
            <source>Puts a backup in the place of the data at the next start. What is there now is set aside. For process engineers, with a reason.</source>
            <translation>다음에 시작할 때 백업이 데이터를 대신합니다. 지금의 것은 따로 보관됩니다. 공정 엔지니어만, 사유와 함께 할 수 있습니다.</translation>
        </message>
        <message>
            <source>Lots</source>
            <translation>로트</translation>
        </message>
        <message>
            <source>Open, choose or close a lot; recipes of the part types.</source>
            <translation>로트를 열고 고르고 닫습니다. 품종의 레시피도 있습니다.</translation>
        </message>
        <message>
            <source>Who is there</source>
            <translation>누가 있는가</translation>
        </message>
        <message>
            <source>Sign on, sign off, people and their roles; a second person for limits.</source>
            <translation>로그인, 로그아웃, 사람과 역할, 한계를 올릴 때의 두 번째 사람입니다.</translation>
        </message>
        <message>
            <source>Settings</source>
            <translation>설정</translation>
        </message>
        <message>
            <source>Language, units, light or dark, size of the text.</source>
            <translation>언어, 단위, 밝거나 어두운 화면, 글자 크기입니다.</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>언어</translation>
        </message>
        <message>
            <source>Korean or English, at once, on all pages.</source>
            <translation>한국어나 영어로, 모든 화면에서 바로 바뀝니다.</translation>
        </message>
        <message>
            <source>Simulator</source>
            <translation>시뮬레이터</translation>
        </message>
        <message>
            <source>How much faster than time the simulated machine runs. A real machine has no such button.</source>
            <translation>시뮬레이션 기계가 시간보다 얼마나 빨리 도는지입니다. 실제 기계에는 없는 단추입니다.</translation>
        </message>
        <message>
            <source>Archive of parts</source>
            <translation>공작물 보관함</translation>
        </message>
        <message>
            <source>The parts turned so far, with surface, force and trim of each.</source>
            <translation>지금까지 가공한 공작물과 각각의 표면, 절삭력, 보정입니다.</translation>
        </message>
        <message>
            <source>Automatic</source>
            <translation>자동</translation>
        </message>
        <message>
            <source>Gain margin</source>
            <translation>게인 여유</translation>
        </message>
        <message>
            <source>How many times stronger the law could act before the force begins to swing; below two it is close.</source>
            <translation>절삭력이 흔들리기 시작하기까지 법칙이 몇 배 더 강해질 수 있는지입니다. 2배보다 작으면 가깝습니다.</translation>
        </message>
        <message>
            <source>Unevenness</source>
            <translation>표면 요철</translation>
        </message>
        <message>
            <source>How far the face is from flat on average (root mean square), as predicted from the force.</source>
            <translation>절삭력에서 예측한 값으로, 면이 평면에서 평균적으로(제곱평균제곱근) 얼마나 벗어났는지입니다.</translation>
        </message>
        <message>
            <source>Highest to lowest point</source>
            <translation>가장 높은 곳과 낮은 곳의 차</translation>
        </message>
        <message>
            <source>Peak to valley of the last whole revolution, as predicted from the force.</source>
            <translation>절삭력에서 예측한, 마지막 한 바퀴의 가장 높은 곳과 가장 낮은 곳의 차입니다.</translation>
        </message>
        <message>
            <source>Without the trim</source>
            <translation>보정이 없을 때</translation>
        </message>
        <message>
            <source>What the unevenness would be if the trim stood still: the difference is the loop's work.</source>
            <translation>보정이 멈춰 있었다면 표면 요철이 얼마였을지입니다. 그 차이가 루프가 한 일입니다.</translation>
        </message>
        <message>
            <source>By how much stronger the cut may answer than it was identified before the loop rings.</source>
            <translation>식별된 것보다 절삭이 몇 배까지 더 세게 반응해도 루프가 떨리지 않는지입니다.</translation>
        </message>
        <message>
            <source>Phase margin</source>
            <translation>위상 여유</translation>
        </message>
        <message>
            <source>By which angle the answer may come later before the loop rings.</source>
            <translation>반응이 어느 각도만큼 늦어져도 루프가 떨리지 않는지입니다.</translation>
        </message>
        <message>
            <source>Delay margin</source>
            <translation>지연 여유</translation>
        </message>
        <message>
            <source>By how much time the answer may come later before the loop rings.</source>
            <translation>반응이 얼마의 시간만큼 늦어져도 루프가 떨리지 않는지입니다.</translation>
        </message>
        <message>
            <source>Modulus margin</source>
            <translation>모듈러스 여유</translation>
        </message>
        <message>
            <source>Smallest distance of the open loop from the point where it rings: 1 is calm, 0 rings.</source>
            <translation>개루프가 떨리기 시작하는 점에서 가장 가까운 거리입니다. 1이면 안정, 0이면 떨립니다.</translation>
        </message>
        <message>
            <source>Rules</source>
            <translation>규칙</translation>
        </message>
        <message>
            <source>Which rules of the charts are on, for page, report and alarm. Few at once: each alarms wrongly now and then.</source>
            <translation>켜져 있는 관리도 규칙입니다. 화면, 보고서, 알람에 적용됩니다. 규칙마다 가끔 잘못 울리므로 조금만 켜십시오.</translation>
        </message>
        <message>
            <source>Parts finished since this console was started, whatever process made them; an air tap makes none.</source>
            <translation>이 콘솔을 시작한 뒤 완성된 공작물 수입니다. 공정은 가리지 않으며, 에어 탭은 세지 않습니다.</translation>
        </message>
        <message>
            <source>Parts begun since this console was started, whatever process made them.</source>
            <translation>이 콘솔을 켠 뒤 시작한 공작물 수로, 어느 공정이든 셉니다.</translation>
        </message>
        <message>
            <source>The parts turned so far, with surface, force and trim of each; one can be left out of what the next begin from, with a reason.</source>
            <translation>지금까지 선삭한 공작물과 각각의 표면, 힘, 보정입니다. 이유를 적고 하나를 다음 공작물이 시작하는 근거에서 뺄 수 있습니다.</translation>
        </message>
        <message>
            <source>Place on the picture</source>
            <translation>그림에 놓기</translation>
        </message>
        <message>
            <source>The channel that was touched gets its point on the picture of the machine: touch where it sits.</source>
            <translation>누른 채널을 기계 그림 위에 놓습니다. 센서가 있는 곳을 누르십시오.</translation>
        </message>
        <message>
            <source>Sensor file and modules</source>
            <translation>센서 파일과 모듈</translation>
        </message>
        <message>
            <source>Which sensor file the next start reads, and what answers at an address of the network.</source>
            <translation>다음에 시작할 때 읽을 센서 파일과, 네트워크 주소에서 응답하는 모듈입니다.</translation>
        </message>
        <message>
            <source>Use this file</source>
            <translation>이 파일 사용</translation>
        </message>
        <message>
            <source>The sensor file that was touched is read from the next start of the console on. For process engineers.</source>
            <translation>누른 센서 파일을 콘솔을 다음에 시작할 때부터 읽습니다. 공정 엔지니어용입니다.</translation>
        </message>
        <message>
            <source>Use none</source>
            <translation>사용 안 함</translation>
        </message>
        <message>
            <source>From the next start on only what the machine itself brings is read.</source>
            <translation>다음 시작부터는 기계가 직접 주는 값만 읽습니다.</translation>
        </message>
        <message>
            <source>Look again</source>
            <translation>다시 찾기</translation>
        </message>
        <message>
            <source>Looks through the folder for sensor files again.</source>
            <translation>폴더에서 센서 파일을 다시 찾습니다.</translation>
        </message>
        <message>
            <source>Ask what is there</source>
            <translation>무엇이 있는지 묻기</translation>
        </message>
        <message>
            <source>Asks units 1 to 32 at the address for their first registers. Nothing is written.</source>
            <translation>그 주소의 1번부터 32번 유닛에 첫 레지스터를 묻습니다. 아무것도 쓰지 않습니다.</translation>
        </message>
    </context>
    <context>
    <name>LotReport</name>
        <message>
            <source>Nothing to show yet.</source>
            <translation>아직 표시할 것이 없습니다.</translation>
        </message>
        <message>
            <source>part %1</source>
            <translation>%1번 공작물</translation>
        </message>
        <message>
            <source>%1: newest parts</source>
            <translation>%1: 최근 공작물</translation>
        </message>
        <message>
            <source>First article of %2, lot %1</source>
            <translation>%2 초품 검사, 로트 %1</translation>
        </message>
        <message>
            <source>Lot %1 of %2</source>
            <translation>%2 로트 %1</translation>
        </message>
        <message>
            <source>%1 on %2, recipe revision %3, opened %4</source>
            <translation>%2의 %1, 레시피 개정 %3, 개시 %4</translation>
        </message>
        <message>
            <source>Drawing, order: ____________________</source>
            <translation>도면, 지시 번호: ____________________</translation>
        </message>
        <message>
            <source>Parts %1 to %2, %3 to %4</source>
            <translation>공작물 %1~%2, %3~%4</translation>
        </message>
        <message>
            <source>%1 parts: %2 good, %3 rework possible, %4 scrap, %5 not judged</source>
            <translation>공작물 %1개: 양품 %2, 재가공 가능 %3, 폐기 %4, 미판정 %5</translation>
        </message>
        <message>
            <source>Characteristic</source>
            <translation>특성</translation>
        </message>
        <message>
            <source>Found</source>
            <translation>측정값</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>공차</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>판정</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>%1~%2</translation>
        </message>
        <message>
            <source>Tolerance %1 to %2, mean %3, s %4</source>
            <translation>공차 %1 ~ %2, 평균 %3, s %4</translation>
        </message>
        <message>
            <source>Measured, with tolerance</source>
            <translation>측정값과 공차</translation>
        </message>
        <message>
            <source>Error against the law, σ</source>
            <translation>법칙 대비 오차, σ</translation>
        </message>
        <message>
            <source>Parts out of tolerance</source>
            <translation>공차를 벗어난 공작물</translation>
        </message>
        <message>
            <source>no decision yet</source>
            <translation>아직 조치 없음</translation>
        </message>
        <message>
            <source>None.</source>
            <translation>없음.</translation>
        </message>
        <message>
            <source>Corrections</source>
            <translation>수정</translation>
        </message>
        <message>
            <source>taken out</source>
            <translation>제외됨</translation>
        </message>
        <message>
            <source>Part %1: %2 → %3, %4, %5: %6</source>
            <translation>%1번 공작물: %2 → %3, %4, %5: %6</translation>
        </message>
        <message>
            <source>tool reground</source>
            <translation>공구 재연삭</translation>
        </message>
        <message>
            <source>other material</source>
            <translation>다른 소재</translation>
        </message>
        <message>
            <source>new insert</source>
            <translation>새 인서트</translation>
        </message>
        <message>
            <source>no change after all</source>
            <translation>변경 없음으로 정정</translation>
        </message>
        <message>
            <source>Signals and changes of the process</source>
            <translation>신호와 공정 변화</translation>
        </message>
        <message>
            <source>From part %1 on: %2</source>
            <translation>%1번 공작물부터: %2</translation>
        </message>
        <message>
            <source>Part %1: %2</source>
            <translation>%1번 공작물: %2</translation>
        </message>
        <message>
            <source>Part %1: the estimator noticed a process change.</source>
            <translation>%1번 공작물: 추정기가 공정 변화를 감지했습니다.</translation>
        </message>
        <message>
            <source>Alarms during the lot</source>
            <translation>로트 중 알람</translation>
        </message>
        <message>
            <source>acknowledged by %1</source>
            <translation>%1 확인</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>게이지</translation>
        </message>
        <message>
            <source>σ of the estimator: %1</source>
            <translation>추정기의 σ: %1</translation>
        </message>
        <message>
            <source>Head of the audit chain: entry %1, %2</source>
            <translation>감사 기록의 끝: 항목 %1, %2</translation>
        </message>
        <message>
            <source>Date, name, signature</source>
            <translation>날짜, 이름, 서명</translation>
        </message>
        <message>
            <source>Kerf %1, written %2. The data is attached as DFQ and CSV.</source>
            <translation>Kerf %1, 작성 %2. 데이터는 DFQ와 CSV로 첨부되어 있습니다.</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <comment>where from, how many</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Values: %1</source>
            <translation>값: %1</translation>
        </message>
        <message>
            <source>Part %1</source>
            <translation>%1번 공작물</translation>
        </message>
        <message>
            <source>Verdict: %1</source>
            <translation>판정: %1</translation>
        </message>
        <message>
            <source>Verdicts: %1 good, %2 rework possible, %3 scrap, %4 not judged</source>
            <translation>판정: 양품 %1, 재가공 가능 %2, 폐기 %3, 미판정 %4</translation>
        </message>
        <message>
            <source>good enough</source>
            <translation>충분함</translation>
        </message>
        <message>
            <source>not good enough</source>
            <translation>부족함</translation>
        </message>
    </context>
    <context>
    <name>Lots</name>
        <message>
            <source>The next parts are of lot %1 of %2.</source>
            <translation>다음 공작물은 %2 품종의 로트 %1에 속합니다.</translation>
        </message>
        <message>
            <source>The next parts of %1 are of no lot.</source>
            <translation>%1 품종의 다음 공작물은 로트에 속하지 않습니다.</translation>
        </message>
        <message>
            <source>Lot</source>
            <translation>로트</translation>
        </message>
        <message>
            <source>Part type</source>
            <translation>품종</translation>
        </message>
        <message>
            <source>Rev.</source>
            <translation>개정</translation>
        </message>
        <message>
            <source>When, by</source>
            <translation>언제, 누가</translation>
        </message>
        <message>
            <source>lot %1</source>
            <translation>로트 %1</translation>
        </message>
        <message>
            <source>Lots of %1</source>
            <translation>%1의 로트</translation>
        </message>
        <message>
            <source>Name of a new lot</source>
            <translation>새 로트 이름</translation>
        </message>
        <message>
            <source>Parts, if known</source>
            <translation>공작물 수(알면)</translation>
        </message>
        <message>
            <source>Tool or insert</source>
            <translation>공구 또는 인서트</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>게이지</translation>
        </message>
        <message>
            <source>Reason to close the lot</source>
            <translation>로트를 닫는 이유</translation>
        </message>
        <message>
            <source>Close the sheet</source>
            <translation>시트 닫기</translation>
        </message>
        <message>
            <source>no lot is open</source>
            <translation>열린 로트가 없습니다</translation>
        </message>
        <message>
            <source>Close the lot</source>
            <translation>로트 닫기</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>이유를 적으십시오</translation>
        </message>
        <message>
            <source>Parts of no lot</source>
            <translation>로트 없이 가공</translation>
        </message>
        <message>
            <source>Go on with it</source>
            <translation>이 로트로 계속</translation>
        </message>
        <message>
            <source>touch a lot</source>
            <translation>로트를 누르십시오</translation>
        </message>
        <message>
            <source>it is closed</source>
            <translation>닫힌 로트입니다</translation>
        </message>
        <message>
            <source>Open the lot</source>
            <translation>로트 열기</translation>
        </message>
        <message>
            <source>type a name</source>
            <translation>이름을 입력하십시오</translation>
        </message>
        <message>
            <source>0 to 100000 parts</source>
            <translation>공작물 0~100000개</translation>
        </message>
        <message>
            <source>Lots</source>
            <translation>로트</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>공작물 수</translation>
        </message>
        <message>
            <source>Tool, gauge</source>
            <translation>공구, 게이지</translation>
        </message>
    </context>
    <context>
    <name>Milling</name>
        <message>
            <source>Constant feed</source>
            <translation>일정 이송</translation>
        </message>
        <message>
            <source>PI</source>
            <translation>PI</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>모델</translation>
        </message>
        <message>
            <source>Preview</source>
            <translation>예측</translation>
        </message>
        <message>
            <source>as long as planned</source>
            <translation>계획과 같은 시간</translation>
        </message>
        <message>
            <source>%1 s faster than planned</source>
            <translation>계획보다 %1 s 빠름</translation>
        </message>
        <message>
            <source>%1 s slower than planned</source>
            <translation>계획보다 %1 s 느림</translation>
        </message>
        <message>
            <source>control would be %1</source>
            <translation>제어하면 %1</translation>
        </message>
        <message>
            <source>peak %1 at %2</source>
            <translation>최대 %1, 위치 %2</translation>
        </message>
        <message>
            <source>waviness %1</source>
            <translation>파상도 %1</translation>
        </message>
        <message>
            <source>would have been stopped</source>
            <translation>제어했다면 정지</translation>
        </message>
        <message>
            <source>was stopped</source>
            <translation>정지됨</translation>
        </message>
        <message>
            <source>Cut %1: %2.</source>
            <translation>절삭 %1: %2.</translation>
        </message>
        <message>
            <source>Cut %1, aborted: %2.</source>
            <translation>절삭 %1, 중단: %2.</translation>
        </message>
        <message>
            <source>typed</source>
            <comment>blank profile</comment>
            <translation>직접 입력</translation>
        </message>
    </context>
    <context>
    <name>MillingCutLog</name>
        <message>
            <source>%1, aborted</source>
            <translation>%1, 중단</translation>
        </message>
        <message>
            <source>Last cuts</source>
            <translation>최근 절삭</translation>
        </message>
        <message>
            <source>An advised cut was made at the planned feed; its controlled time is what control would have taken.</source>
            <translation>추천 절삭은 계획 이송으로 가공했으며, 제어 시간은 제어했을 때 걸렸을 시간입니다.</translation>
        </message>
        <message>
            <source>cut</source>
            <translation>절삭</translation>
        </message>
        <message>
            <source>law</source>
            <translation>법칙</translation>
        </message>
        <message>
            <source>mode</source>
            <translation>모드</translation>
        </message>
        <message>
            <source>planned
%1</source>
            <translation>계획
%1</translation>
        </message>
        <message>
            <source>controlled
%1</source>
            <translation>제어
%1</translation>
        </message>
        <message>
            <source>peak
%1</source>
            <translation>최대
%1</translation>
        </message>
        <message>
            <source>at
%1</source>
            <translation>위치
%1</translation>
        </message>
        <message>
            <source>waviness
%1</source>
            <translation>파상도
%1</translation>
        </message>
        <message>
            <source>stops</source>
            <translation>정지</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
    </context>
    <context>
    <name>OperatorChooser</name>
        <message>
            <source>Who is at the machine?</source>
            <translation>작업자가 누구입니까?</translation>
        </message>
        <message>
            <source>The name goes with every entry and correction.</source>
            <translation>입력과 수정마다 이 이름이 함께 기록됩니다.</translation>
        </message>
        <message>
            <source>New name</source>
            <translation>새 이름</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Sign off</source>
            <translation>로그아웃</translation>
        </message>
        <message>
            <source>Sign on</source>
            <translation>로그인</translation>
        </message>
        <message>
            <source>Type your PIN.</source>
            <translation>PIN을 입력하십시오.</translation>
        </message>
        <message>
            <source>This PIN does not fit.</source>
            <translation>PIN이 맞지 않습니다.</translation>
        </message>
        <message>
            <source>People</source>
            <translation>사용자</translation>
        </message>
        <message>
            <source>nobody is known yet</source>
            <translation>등록된 사람이 없음</translation>
        </message>
        <message>
            <source>Demonstration on a simulated machine: a new name may take any role until there is a process engineer.</source>
            <translation>모의 기계에서의 시연입니다. 공정 엔지니어가 생길 때까지 새 이름은 어떤 역할이든 가질 수 있습니다.</translation>
        </message>
        <message>
            <source>Who says yes as well?</source>
            <translation>누가 함께 승인합니까?</translation>
        </message>
        <message>
            <source>For two minutes %1 may raise a limit by more than half.</source>
            <translation>2분 동안 %1 님이 한계를 절반 넘게 올릴 수 있습니다.</translation>
        </message>
        <message>
            <source>Second person</source>
            <translation>두 번째 사람</translation>
        </message>
        <message>
            <source>no other setter or engineer has a PIN</source>
            <translation>PIN이 있는 다른 셋업 담당자나 공정 엔지니어가 없음</translation>
        </message>
        <message>
            <source>%1 has said yes</source>
            <translation>%1 님이 확인했습니다</translation>
        </message>
    </context>
    <context>
    <name>Pages</name>
        <message>
            <source>Feed</source>
            <translation>이송</translation>
        </message>
        <message>
            <source>Next bore</source>
            <translation>다음 내경</translation>
        </message>
        <message>
            <source>Next bore, %1</source>
            <translation>다음 내경, %1</translation>
        </message>
        <message>
            <source>Overview</source>
            <translation>전체 보기</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>알람</translation>
        </message>
        <message>
            <source>Diagnostics</source>
            <translation>진단</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>Waviness of the cut</source>
            <translation>절삭의 파상도</translation>
        </message>
        <message>
            <source>Last tap, p-p in the work</source>
            <translation>마지막 탭, 가공 구간 p-p</translation>
        </message>
        <message>
            <source>Sensors</source>
            <translation>센서</translation>
        </message>
        <message>
            <source>Quality</source>
            <translation>품질</translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>근무조</translation>
        </message>
        <message>
            <source>Tuned tap, p-p in the work</source>
            <translation>튜닝한 탭, 가공 구간 p-p</translation>
        </message>
    </context>
    <context>
    <name>PartReport</name>
        <message>
            <source>Feed over overhang, %1 over %2: dashed the schedule, solid as cut.</source>
            <comment>units</comment>
            <translation>돌출 길이에 대한 이송(%1, %2): 파선은 이송 계획, 실선은 실제 절삭.</translation>
        </message>
        <message>
            <source>correction</source>
            <translation>수정</translation>
        </message>
        <message>
            <source>taken out</source>
            <translation>제외</translation>
        </message>
        <message>
            <source>confirmed</source>
            <translation>확인함</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>깊이</translation>
        </message>
        <message>
            <source>⌀, %1</source>
            <translation>⌀, %1</translation>
        </message>
        <message>
            <source>By, when</source>
            <translation>누가, 언제</translation>
        </message>
        <message>
            <source>What, why</source>
            <translation>내용, 사유</translation>
        </message>
        <message>
            <source>no longer holds</source>
            <translation>더 이상 유효하지 않음</translation>
        </message>
        <message>
            <source>Nothing was measured.</source>
            <translation>측정값이 없습니다.</translation>
        </message>
        <message>
            <source>Part %1, lot %2</source>
            <translation>공작물 %1, 로트 %2</translation>
        </message>
        <message>
            <source>No serial number</source>
            <translation>일련번호 없음</translation>
        </message>
        <message>
            <source>Serial number %1</source>
            <translation>일련번호 %1</translation>
        </message>
        <message>
            <source>cut in %1 s</source>
            <translation>절삭 시간 %1초</translation>
        </message>
        <message>
            <source>finished</source>
            <translation>완료</translation>
        </message>
        <message>
            <source>aborted</source>
            <translation>중단</translation>
        </message>
        <message>
            <source>The estimator noticed a process change with this part.</source>
            <translation>이 공작물에서 공정 변화가 감지되었습니다.</translation>
        </message>
        <message>
            <source>Kerf %1, written %2</source>
            <translation>Kerf %1, 작성 %2</translation>
        </message>
        <message>
            <source>Verdict: %1</source>
            <translation>판정: %1</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <comment>limits</comment>
            <translation>%1~%2</translation>
        </message>
        <message>
            <source>Decided: %1, by %2, %3</source>
            <translation>조치: %1, %2, %3</translation>
        </message>
        <message>
            <source>Nobody has decided yet what is done with it.</source>
            <translation>아직 아무도 조치를 결정하지 않았습니다.</translation>
        </message>
        <message>
            <source>Part %1</source>
            <translation>공작물 %1</translation>
        </message>
    </context>
    <context>
    <name>People</name>
        <message>
            <source>No PIN</source>
            <translation>PIN 없음</translation>
        </message>
        <message>
            <source>Has a PIN</source>
            <translation>PIN 있음</translation>
        </message>
        <message>
            <source>PIN of %1</source>
            <translation>%1의 PIN</translation>
        </message>
        <message>
            <source>%1 to %2 digits; nothing asks for none.</source>
            <translation>숫자 %1~%2자리. 비워 두면 묻지 않습니다.</translation>
        </message>
        <message>
            <source>A PIN has %1 to %2 digits.</source>
            <translation>PIN은 숫자 %1~%2자리입니다.</translation>
        </message>
        <message>
            <source>People at this machine</source>
            <translation>이 기계의 사용자</translation>
        </message>
        <message>
            <source>Operators enter and correct diameters. Setters also open lots and switch loops. Process engineers also change recipes, limits and this list.</source>
            <translation>작업자는 지름을 입력하고 수정합니다. 셋업 담당자는 로트를 열고 루프를 전환할 수도 있습니다. 공정 엔지니어는 레시피와 한계, 이 목록도 바꿀 수 있습니다.</translation>
        </message>
        <message>
            <source>Sign off when nobody has touched anything for</source>
            <translation>조작이 없으면 로그아웃하는 시간</translation>
        </message>
        <message>
            <source>never</source>
            <translation>안 함</translation>
        </message>
        <message>
            <source>%1 min</source>
            <translation>%1분</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>Who may do what</source>
            <translation>누가 무엇을 할 수 있는가</translation>
        </message>
        <message>
            <source>Each role may do what the ones before it may. Starting a part, HOLD ALL and its release, and ending a tap ask for no name.</source>
            <translation>각 권한은 앞 권한이 할 수 있는 일도 할 수 있습니다. 공작물 시작, 전체 홀드와 그 해제, 탭 종료에는 이름이 필요 없습니다.</translation>
        </message>
        <message>
            <source>what</source>
            <translation>항목</translation>
        </message>
        <message>
            <source>from this role on</source>
            <translation>필요한 최소 권한</translation>
        </message>
        <message>
            <source>reason</source>
            <translation>사유</translation>
        </message>
        <message>
            <source>must be given</source>
            <translation>입력 필수</translation>
        </message>
        <message>
            <source>Take off</source>
            <translation>목록에서 빼기</translation>
        </message>
        <message>
            <source>Take %1 off the list?</source>
            <translation>%1 님을 목록에서 뺄까요?</translation>
        </message>
        <message>
            <source>What was done under this name keeps it. Who comes back signs on anew, as an operator.</source>
            <translation>이 이름으로 한 일에는 이름이 남습니다. 다시 오면 작업자로 새로 로그인합니다.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
    </context>
    <context>
    <name>PinSheet</name>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
    </context>
    <context>
    <name>QualityTexts</name>
        <message>
            <source>Bore ⌀, %1</source>
            <translation>내경 ⌀, %1</translation>
        </message>
        <message>
            <source>n %1</source>
            <translation>n %1</translation>
        </message>
        <message>
            <source>%1 %2 (%3 to %4)</source>
            <comment>index with its interval</comment>
            <translation>%1 %2 (%3 ~ %4)</translation>
        </message>
        <message>
            <source>preliminary</source>
            <translation>잠정</translation>
        </message>
        <message>
            <source>tool from part %1</source>
            <translation>공작물 %1부터의 공구</translation>
        </message>
        <message>
            <source>entered by %1</source>
            <translation>%1 입력</translation>
        </message>
        <message>
            <source>read from the gauge</source>
            <translation>게이지에서 읽음</translation>
        </message>
        <message>
            <source>typed on the keypad</source>
            <translation>키패드로 입력</translation>
        </message>
        <message>
            <source>read from gauge %1</source>
            <translation>게이지 %1에서 읽음</translation>
        </message>
        <message>
            <source>from file %1</source>
            <translation>파일 %1에서</translation>
        </message>
        <message>
            <source>lot %1</source>
            <translation>로트 %1</translation>
        </message>
    </context>
    <context>
    <name>Restore</name>
        <message>
            <source>Not restored</source>
            <translation>복원하지 못했습니다</translation>
        </message>
        <message>
            <source>The backup is whole and waits</source>
            <translation>백업이 온전하며 대기 중입니다</translation>
        </message>
        <message>
            <source>It takes the place of the data at the next start of Kerf. What is stored until then goes aside with the data that are there now.</source>
            <translation>다음에 Kerf를 시작할 때 지금의 데이터를 대신합니다. 그때까지 저장되는 것은 지금의 데이터와 함께 따로 보관됩니다.</translation>
        </message>
        <message>
            <source>Later</source>
            <translation>나중에</translation>
        </message>
        <message>
            <source>End Kerf now</source>
            <translation>지금 Kerf 끝내기</translation>
        </message>
        <message>
            <source>Put this backup in the place of the data?</source>
            <translation>이 백업으로 데이터를 바꿀까요?</translation>
        </message>
        <message>
            <source>%1, of %2. Everything stored since then goes aside into a file of its own, nothing is deleted.</source>
            <translation>%1, %2. 그 뒤에 저장된 것은 모두 다른 파일로 따로 보관되며 지워지는 것은 없습니다.</translation>
        </message>
        <message>
            <source>Why</source>
            <translation>사유</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Check it and lay it ready</source>
            <translation>검사하고 준비하기</translation>
        </message>
        <message>
            <source>Restore a backup</source>
            <translation>백업 복원</translation>
        </message>
        <message>
            <source>No backup lies on a removable drive, among the documents or in the backups folder of the data.</source>
            <translation>이동식 드라이브, 문서 폴더, 데이터의 backups 폴더에 백업이 없습니다.</translation>
        </message>
        <message>
            <source>Touch the one that shall take the place of the data; it is checked first.</source>
            <translation>데이터를 대신할 백업을 누르십시오. 먼저 검사합니다.</translation>
        </message>
        <message>
            <source>The backup is whole and takes the place of the data at the next start.</source>
            <translation>백업이 온전하며, 다음에 시작할 때 지금의 데이터를 대신합니다.</translation>
        </message>
        <message>
            <source>Not restored: %1</source>
            <translation>복원하지 못했습니다: %1</translation>
        </message>
        <message>
            <source>It is being checked …</source>
            <translation>확인하는 중 …</translation>
        </message>
    </context>
    <context>
    <name>Revisions</name>
        <message>
            <source>and %1 more values</source>
            <translation>그 밖에 값 %1개</translation>
        </message>
        <message>
            <source>The same values as now.</source>
            <translation>지금과 같은 값입니다.</translation>
        </message>
        <message>
            <source>Rev.</source>
            <translation>개정</translation>
        </message>
        <message>
            <source>When, by</source>
            <translation>언제, 누가</translation>
        </message>
        <message>
            <source>Why</source>
            <translation>사유</translation>
        </message>
        <message>
            <source>back to %1: %2</source>
            <comment>revision, reason</comment>
            <translation>%1(으)로 되돌림: %2</translation>
        </message>
        <message>
            <source>Revisions of %1</source>
            <translation>%1의 개정</translation>
        </message>
        <message>
            <source>Nothing was changed yet.</source>
            <translation>아직 바뀐 것이 없습니다.</translation>
        </message>
        <message>
            <source>The first one holds. Touch an older one to compare it.</source>
            <translation>맨 위의 것이 적용 중입니다. 이전 것을 터치하면 비교합니다.</translation>
        </message>
        <message>
            <source>Reason for the change</source>
            <translation>변경 사유</translation>
        </message>
        <message>
            <source>Roll back to it</source>
            <translation>이 개정으로 되돌리기</translation>
        </message>
        <message>
            <source>touch an older revision</source>
            <translation>이전 개정을 누르십시오</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>사유를 쓰십시오</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>The revision is back.</source>
            <translation>개정을 되돌렸습니다.</translation>
        </message>
        <message>
            <source>Earlier revisions</source>
            <translation>이전 개정</translation>
        </message>
        <message>
            <source>%1, lower limit</source>
            <translation>%1, 하한</translation>
        </message>
        <message>
            <source>%1, upper limit</source>
            <translation>%1, 상한</translation>
        </message>
        <message>
            <source>none</source>
            <comment>limit</comment>
            <translation>없음</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>예</translation>
        </message>
        <message>
            <source>no</source>
            <translation>아니요</translation>
        </message>
    </context>
    <context>
    <name>Settings</name>
        <message>
            <source>Settings</source>
            <translation>설정</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>언어</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>길이 단위</translation>
        </message>
        <message>
            <source>Temperature</source>
            <translation>온도 단위</translation>
        </message>
        <message>
            <source>Theme</source>
            <translation>화면 색</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>크기</translation>
        </message>
        <message>
            <source>inch</source>
            <translation>인치</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>밝게</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>어둡게</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>Figures in</source>
            <translation>수치 이름</translation>
        </message>
        <message>
            <source>Shop words</source>
            <translation>현장 용어</translation>
        </message>
        <message>
            <source>Symbols</source>
            <translation>기호</translation>
        </message>
    </context>
    <context>
    <name>Shift</name>
        <message>
            <source>no reason given yet</source>
            <translation>아직 사유 없음</translation>
        </message>
        <message>
            <source>Setting up</source>
            <translation>준비 작업</translation>
        </message>
        <message>
            <source>Tool change</source>
            <translation>공구 교환</translation>
        </message>
        <message>
            <source>No material</source>
            <translation>소재 없음</translation>
        </message>
        <message>
            <source>Measuring</source>
            <translation>측정</translation>
        </message>
        <message>
            <source>Fault, repair</source>
            <translation>고장, 수리</translation>
        </message>
        <message>
            <source>Cleaning, chips</source>
            <translation>청소, 칩 제거</translation>
        </message>
        <message>
            <source>No order</source>
            <translation>작업 지시 없음</translation>
        </message>
        <message>
            <source>Break, nobody there</source>
            <translation>휴식, 작업자 없음</translation>
        </message>
        <message>
            <source>Something else</source>
            <translation>기타</translation>
        </message>
        <message>
            <source>%1 made</source>
            <translation>생산 %1</translation>
        </message>
        <message>
            <source>%1 good</source>
            <translation>양품 %1</translation>
        </message>
        <message>
            <source>%1 rework</source>
            <translation>재가공 %1</translation>
        </message>
        <message>
            <source>%1 scrap</source>
            <translation>폐기 %1</translation>
        </message>
        <message>
            <source>%1 not judged</source>
            <translation>미판정 %1</translation>
        </message>
        <message>
            <source>%1 broken off</source>
            <translation>중단 %1</translation>
        </message>
        <message>
            <source>%1 min in the cut</source>
            <translation>절삭 %1분</translation>
        </message>
        <message numerus="yes">
            <source>%1 min saved in %n milled parts against the planned feed.</source>
            <translation>
                <numerusform>밀링 공작물 %n개에서 계획 이송 대비 %1분 절약.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 of %n bores are inside the tolerance that the recipe's first feed would have put outside.</source>
            <translation>
                <numerusform>내경 %n개 중 %1개: 레시피의 첫 이송이었다면 공차를 벗어났을 것.</numerusform>
            </translation>
        </message>
        <message>
            <source>What the loops have saved is computed from milled parts and measured bores.</source>
            <translation>제어로 절약한 시간과 공작물은 밀링 공작물과 측정한 내경에서 계산합니다.</translation>
        </message>
        <message>
            <source>change announced</source>
            <translation>변경을 알림</translation>
        </message>
        <message>
            <source>tool and material of a lot named</source>
            <translation>로트의 공구와 소재를 적음</translation>
        </message>
        <message>
            <source>lot left out of memory or taken in</source>
            <translation>로트를 기억에서 빼거나 다시 넣음</translation>
        </message>
        <message>
            <source>controller chosen</source>
            <translation>제어기 선택</translation>
        </message>
        <message>
            <source>part out of tolerance dealt with</source>
            <translation>공차를 벗어난 공작물 처리</translation>
        </message>
        <message>
            <source>limits of the figures</source>
            <translation>수치의 한계</translation>
        </message>
        <message>
            <source>gap sensors read</source>
            <translation>갭 센서 읽음</translation>
        </message>
        <message>
            <source>gap sensors set to zero</source>
            <translation>갭 센서 영점</translation>
        </message>
        <message>
            <source>gauge registered</source>
            <translation>게이지 등록</translation>
        </message>
        <message>
            <source>gauge study made</source>
            <translation>게이지 평가</translation>
        </message>
        <message>
            <source>model put live</source>
            <translation>모델 적용</translation>
        </message>
        <message>
            <source>sensors placed</source>
            <translation>센서 위치 지정</translation>
        </message>
        <message>
            <source>session recorded</source>
            <translation>기록 저장</translation>
        </message>
        <message>
            <source>setup changed</source>
            <translation>설정 변경</translation>
        </message>
        <message>
            <source>new tool</source>
            <translation>새 공구</translation>
        </message>
        <message>
            <source>tool life set</source>
            <translation>공구 수명 설정</translation>
        </message>
        <message>
            <source>tool left out of memory or taken in</source>
            <translation>공구를 기억에서 빼거나 다시 넣음</translation>
        </message>
        <message>
            <source>tuning accepted</source>
            <translation>튜닝 수락</translation>
        </message>
        <message>
            <source>Account changed</source>
            <translation>계정 변경</translation>
        </message>
        <message>
            <source>Account made</source>
            <translation>계정 추가</translation>
        </message>
        <message>
            <source>Alarm acknowledged</source>
            <translation>알람 확인</translation>
        </message>
        <message>
            <source>Diameter corrected</source>
            <translation>지름 수정</translation>
        </message>
        <message>
            <source>Lot closed</source>
            <translation>로트 닫음</translation>
        </message>
        <message>
            <source>Lot opened</source>
            <translation>로트 엶</translation>
        </message>
        <message>
            <source>Diameter entered</source>
            <translation>지름 입력</translation>
        </message>
        <message>
            <source>Measured origin taken over</source>
            <translation>측정한 원점을 받아들임</translation>
        </message>
        <message>
            <source>Origin measured</source>
            <translation>원점 측정</translation>
        </message>
        <message>
            <source>Recipe rolled back</source>
            <translation>레시피 되돌림</translation>
        </message>
        <message>
            <source>Recipe saved</source>
            <translation>레시피 저장</translation>
        </message>
        <message>
            <source>Thermal reference taken</source>
            <translation>열변위 기준 지정</translation>
        </message>
        <message>
            <source>Thermal reference taken, shift back to zero</source>
            <translation>열변위 기준 지정, 이동량 0으로</translation>
        </message>
        <message>
            <source>Refused for want of rights</source>
            <translation>권한이 없어 거절</translation>
        </message>
        <message>
            <source>Feed schedule accepted</source>
            <translation>이송 계획 수락</translation>
        </message>
        <message>
            <source>Serial number set</source>
            <translation>일련번호 지정</translation>
        </message>
        <message>
            <source>Setting changed:</source>
            <translation>설정 변경:</translation>
        </message>
        <message>
            <source>Wrong PIN</source>
            <translation>틀린 PIN</translation>
        </message>
        <message>
            <source>PIN removed:</source>
            <translation>PIN 삭제:</translation>
        </message>
        <message>
            <source>PIN set:</source>
            <translation>PIN 지정:</translation>
        </message>
        <message>
            <source>First process engineer made</source>
            <translation>첫 공정 엔지니어 등록</translation>
        </message>
        <message>
            <source>Role set:</source>
            <translation>역할 지정:</translation>
        </message>
        <message>
            <source>Diameter taken out</source>
            <translation>지름 뺌</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>no lot selected any more</source>
            <translation>선택된 로트 없음</translation>
        </message>
        <message>
            <source>lot selected</source>
            <translation>로트 선택</translation>
        </message>
        <message>
            <source>Account removed</source>
            <translation>계정 삭제</translation>
        </message>
        <message>
            <source>Second person:</source>
            <translation>두 번째 사람:</translation>
        </message>
        <message>
            <source>operator</source>
            <translation>작업자</translation>
        </message>
        <message>
            <source>setter</source>
            <translation>셋업 담당자</translation>
        </message>
        <message>
            <source>process engineer</source>
            <translation>공정 엔지니어</translation>
        </message>
        <message>
            <source>no PIN</source>
            <translation>PIN 없음</translation>
        </message>
        <message>
            <source>PIN</source>
            <translation>PIN</translation>
        </message>
        <message>
            <source>new PIN</source>
            <translation>새 PIN</translation>
        </message>
        <message>
            <source>part left out of memory or taken in</source>
            <translation>공작물을 기억에서 빼거나 다시 넣음</translation>
        </message>
    </context>
    <context>
    <name>ShiftReport</name>
        <message numerus="yes">
            <source>and %n more</source>
            <translation>
                <numerusform>외 %n건</numerusform>
            </translation>
        </message>
        <message>
            <source>Shift</source>
            <translation>근무조</translation>
        </message>
        <message>
            <source>%1 to %2</source>
            <translation>%1부터 %2까지</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>No part was finished.</source>
            <translation>완료된 공작물이 없습니다.</translation>
        </message>
        <message numerus="yes">
            <source>%n minutes</source>
            <translation>
                <numerusform>%n분</numerusform>
            </translation>
        </message>
        <message>
            <source>Stops</source>
            <translation>정지</translation>
        </message>
        <message>
            <source>Nothing stood longer than three minutes.</source>
            <translation>3분을 넘는 정지가 없습니다.</translation>
        </message>
        <message>
            <source>Changes</source>
            <translation>변경</translation>
        </message>
        <message>
            <source>Nothing was changed.</source>
            <translation>변경 사항이 없습니다.</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>알람</translation>
        </message>
        <message>
            <source>No alarm came.</source>
            <translation>알람이 없었습니다.</translation>
        </message>
        <message>
            <source>Notes</source>
            <translation>메모</translation>
        </message>
        <message>
            <source>No note was left.</source>
            <translation>남긴 메모가 없습니다.</translation>
        </message>
        <message>
            <source>Handed over: ____________________</source>
            <translation>인계자: ____________________</translation>
        </message>
        <message>
            <source>Taken over: ____________________</source>
            <translation>인수자: ____________________</translation>
        </message>
    </context>
    <context>
    <name>ShopText</name>
        <message>
            <source>%1 s ago</source>
            <translation>%1초 전</translation>
        </message>
        <message>
            <source>%1 min ago</source>
            <translation>%1분 전</translation>
        </message>
        <message>
            <source>%1 h ago</source>
            <translation>%1시간 전</translation>
        </message>
        <message>
            <source>The shop's database is not prepared for consoles.</source>
            <translation>공장 서버의 데이터베이스가 콘솔용으로 준비되지 않았습니다.</translation>
        </message>
        <message>
            <source>The shop does not let this console in: enrol it.</source>
            <translation>공장 서버가 이 콘솔을 허용하지 않습니다. 등록하십시오.</translation>
        </message>
        <message>
            <source>This console is newer than the shop: bring the shop up to date.</source>
            <translation>이 콘솔이 공장 서버보다 새 버전입니다. 공장 서버를 갱신하십시오.</translation>
        </message>
        <message>
            <source>The data file cannot be read for the shop.</source>
            <translation>공장 서버로 보낼 데이터 파일을 읽을 수 없습니다.</translation>
        </message>
        <message>
            <source>The shop's address cannot be used.</source>
            <translation>공장 서버 주소를 사용할 수 없습니다.</translation>
        </message>
        <message>
            <source>The shop is out of reach.</source>
            <translation>공장 서버에 연결할 수 없습니다.</translation>
        </message>
        <message>
            <source>%1 entries wait here; nothing is lost.</source>
            <translation>%1개 항목이 여기서 대기 중입니다. 손실은 없습니다.</translation>
        </message>
        <message>
            <source>Everything is in the shop.</source>
            <translation>모든 항목이 공장 서버에 있습니다.</translation>
        </message>
        <message>
            <source>The shop is being called.</source>
            <translation>공장 서버에 연결하는 중입니다.</translation>
        </message>
        <message>
            <source>%1 entries were put aside there: have them looked at.</source>
            <translation>%1개 항목이 서버에서 따로 보관되었습니다. 확인하십시오.</translation>
        </message>
        <message>
            <source>Last contact %1.</source>
            <comment>an age</comment>
            <translation>마지막 연결 %1.</translation>
        </message>
    </context>
    <context>
    <name>SourceTexts</name>
        <message>
            <source>typed</source>
            <translation>입력</translation>
        </message>
        <message>
            <source>gauge</source>
            <translation>게이지</translation>
        </message>
        <message>
            <source>gauge %1</source>
            <translation>게이지 %1</translation>
        </message>
        <message>
            <source>file %1</source>
            <translation>파일 %1</translation>
        </message>
    </context>
    <context>
    <name>StartObstacle</name>
        <message>
            <source>No link to the machine.</source>
            <translation>기계와 연결되지 않았습니다.</translation>
        </message>
        <message>
            <source>Emergency stop is pressed.</source>
            <translation>비상정지가 눌려 있습니다.</translation>
        </message>
        <message>
            <source>The machine is off.</source>
            <translation>기계가 꺼져 있습니다.</translation>
        </message>
        <message>
            <source>Hold is in force.</source>
            <translation>홀드 상태입니다.</translation>
        </message>
        <message>
            <source>A stop stands: look at the machine, then release it.</source>
            <translation>정지가 걸려 있습니다: 기계를 확인한 뒤 해제하십시오.</translation>
        </message>
        <message>
            <source>Start the program at the control.</source>
            <translation>제어기에서 프로그램을 시작하십시오.</translation>
        </message>
        <message>
            <source>Finished parts are not stored yet.</source>
            <translation>끝난 공작물이 아직 저장되지 않았습니다.</translation>
        </message>
        <message>
            <source>A part is being cut.</source>
            <translation>공작물을 가공하고 있습니다.</translation>
        </message>
        <message>
            <source>The machine is busy: %1.</source>
            <translation>기계가 사용 중입니다: %1.</translation>
        </message>
    </context>
    <context>
    <name>StartRest</name>
        <message>
            <source>Loading what was just stored.</source>
            <translation>방금 저장한 내용 적용 중</translation>
        </message>
    </context>
    <context>
    <name>TappingTexts</name>
        <message>
            <source>%1, %2 rpm, %3 rev, gear %4</source>
            <comment>thread, speed, depth, gear</comment>
            <translation>%1, %2 rpm, %3회전, 기어 %4</translation>
        </message>
        <message>
            <source>not tuned</source>
            <translation>튜닝 안 됨</translation>
        </message>
        <message>
            <source>tuned</source>
            <translation>튜닝됨</translation>
        </message>
        <message>
            <source>air tap</source>
            <translation>에어 탭</translation>
        </message>
        <message>
            <source>trial %1</source>
            <translation>시험 탭 %1</translation>
        </message>
        <message>
            <source>tuned, to be accepted</source>
            <translation>튜닝 완료, 수락 대기</translation>
        </message>
        <message>
            <source>proposal</source>
            <translation>제안</translation>
        </message>
        <message>
            <source>accepted</source>
            <translation>수락됨</translation>
        </message>
        <message>
            <source>rolled back</source>
            <translation>되돌림</translation>
        </message>
        <message>
            <source>tuning ended</source>
            <translation>튜닝 종료</translation>
        </message>
        <message>
            <source>The machine's own gains: nothing is stored for this job.</source>
            <translation>기계 고유 게인: 이 작업에 저장된 튜닝이 없습니다.</translation>
        </message>
        <message>
            <source>Gains and trim of the stored tuning of this job.</source>
            <translation>이 작업에 저장된 튜닝의 게인과 보정.</translation>
        </message>
        <message>
            <source>Gains stored for this speed range; the trim does not fit: tune before production.</source>
            <translation>이 속도 범위에 저장된 게인; 보정은 맞지 않습니다: 생산 전에 튜닝하십시오.</translation>
        </message>
        <message>
            <source>Gains of this tuning.</source>
            <translation>이번 튜닝의 게인.</translation>
        </message>
        <message>
            <source>sum of errors %1 → %2 (−%3 %), in the work %4 → %5 p-p</source>
            <translation>오차 합 %1 → %2 (−%3 %), 가공 구간 p-p %4 → %5</translation>
        </message>
        <message>
            <source>Rolled back by %1; the tuning had: %2.</source>
            <translation>%1 님이 되돌림; 그 튜닝: %2.</translation>
        </message>
        <message>
            <source>Before and after, accepted by %1: %2.</source>
            <translation>전과 후, %1 님 수락: %2.</translation>
        </message>
    </context>
    <context>
    <name>ThermalSheets</name>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>The model that is live</source>
            <translation>현재 사용 중인 모델</translation>
        </message>
        <message>
            <source>what</source>
            <translation>항목</translation>
        </message>
        <message>
            <source>value</source>
            <translation>값</translation>
        </message>
        <message>
            <source>Back to the model before</source>
            <translation>이전 모델로 되돌리기</translation>
        </message>
        <message>
            <source>there is no model before this</source>
            <translation>이전 모델이 없습니다</translation>
        </message>
        <message>
            <source>Train a new one</source>
            <translation>새로 학습</translation>
        </message>
        <message>
            <source>model</source>
            <translation>모델</translation>
        </message>
        <message>
            <source>the first one is being trained</source>
            <translation>첫 모델을 학습하고 있습니다</translation>
        </message>
        <message>
            <source>none yet</source>
            <translation>아직 없음</translation>
        </message>
        <message>
            <source>%1, no. %2</source>
            <translation>%1, %2번</translation>
        </message>
        <message>
            <source>error on days left out, X / Y / Z</source>
            <translation>제외한 날의 오차, X / Y / Z</translation>
        </message>
        <message>
            <source>error on its own check rows, X / Y / Z</source>
            <translation>자체 검사 행의 오차, X / Y / Z</translation>
        </message>
        <message>
            <source>rms %1, worst %2 %3</source>
            <translation>rms %1, 최대 %2 %3</translation>
        </message>
        <message>
            <source>live since</source>
            <translation>사용 시작</translation>
        </message>
        <message>
            <source>%1, %2 h ago, by %3</source>
            <translation>%1, %2시간 전, %3</translation>
        </message>
        <message>
            <source>thermocouples</source>
            <translation>열전대</translation>
        </message>
        <message>
            <source>trained on</source>
            <translation>학습 데이터</translation>
        </message>
        <message>
            <source>%1 (%2 rows)</source>
            <translation>%1 (%2행)</translation>
        </message>
        <message>
            <source>formula</source>
            <translation>식</translation>
        </message>
        <message>
            <source>file</source>
            <translation>파일</translation>
        </message>
        <message>
            <source>recorded here</source>
            <translation>여기서 기록</translation>
        </message>
        <message>
            <source>built-in simulation</source>
            <translation>내장 시뮬레이션</translation>
        </message>
        <message>
            <source>Train a model</source>
            <translation>모델 학습</translation>
        </message>
        <message>
            <source>Touch the days to train on. Several days of different work make a model that also holds on days it has not seen. History files belong in %1.</source>
            <translation>학습할 날을 누르십시오. 작업이 서로 다른 여러 날로 학습하면 보지 못한 날에도 맞는 모델이 됩니다. 이력 파일은 %1에 넣으십시오.</translation>
        </message>
        <message>
            <source>use</source>
            <translation>사용</translation>
        </message>
        <message>
            <source>day</source>
            <translation>날</translation>
        </message>
        <message>
            <source>from</source>
            <translation>출처</translation>
        </message>
        <message>
            <source>rms X / Y / Z, %1</source>
            <translation>rms X / Y / Z, %1</translation>
        </message>
        <message>
            <source>worst X / Y / Z</source>
            <translation>최대 X / Y / Z</translation>
        </message>
        <message>
            <source>Cancel training</source>
            <translation>학습 취소</translation>
        </message>
        <message>
            <source>Train and compare</source>
            <translation>학습하고 비교</translation>
        </message>
        <message>
            <source>Go live</source>
            <translation>적용</translation>
        </message>
        <message>
            <source>nothing is being trained</source>
            <translation>학습 중이 아닙니다</translation>
        </message>
        <message>
            <source>a model is being trained</source>
            <translation>모델을 학습하고 있습니다</translation>
        </message>
        <message>
            <source>choose days first</source>
            <translation>먼저 날을 고르십시오</translation>
        </message>
        <message>
            <source>train one first</source>
            <translation>먼저 학습하십시오</translation>
        </message>
        <message>
            <source>The comparison appears below after the training.</source>
            <translation>학습이 끝나면 비교표가 아래에 나타납니다.</translation>
        </message>
        <message>
            <source>Training: %1 %</source>
            <translation>학습 중: %1 %</translation>
        </message>
        <message>
            <source>Errors on days left out of the training. The live model goes on until you go live.</source>
            <translation>학습에서 제외한 날의 오차입니다. 적용할 때까지 현재 모델이 계속 쓰입니다.</translation>
        </message>
        <message>
            <source>Cancelled; nothing has changed.</source>
            <translation>취소했습니다. 바뀐 것은 없습니다.</translation>
        </message>
        <message>
            <source>%1: best</source>
            <translation>%1: 최선</translation>
        </message>
        <message>
            <source>Measure the origin</source>
            <translation>원점 측정</translation>
        </message>
        <message>
            <source>axis</source>
            <translation>축</translation>
        </message>
        <message>
            <source>measured</source>
            <translation>측정</translation>
        </message>
        <message>
            <source>predicted</source>
            <translation>예측</translation>
        </message>
        <message>
            <source>difference</source>
            <translation>차이</translation>
        </message>
        <message>
            <source>verdict</source>
            <translation>판정</translation>
        </message>
        <message>
            <source>New reference</source>
            <translation>새 기준</translation>
        </message>
        <message>
            <source>Take over</source>
            <translation>측정값 적용</translation>
        </message>
        <message>
            <source>Measure now</source>
            <translation>지금 측정</translation>
        </message>
        <message>
            <source>the gap sensors read nothing</source>
            <translation>갭 센서가 읽히지 않습니다</translation>
        </message>
        <message>
            <source>take a reference first</source>
            <translation>먼저 기준을 잡으십시오</translation>
        </message>
        <message>
            <source>being measured</source>
            <translation>측정 중</translation>
        </message>
        <message>
            <source>measure first</source>
            <translation>먼저 측정하십시오</translation>
        </message>
        <message>
            <source>Count from now on?</source>
            <translation>지금부터 기준으로 할까요?</translation>
        </message>
        <message>
            <source>The machine must be as cold as it is at the start of a day, and the origin set anew. The shift goes back to zero.</source>
            <translation>기계가 하루를 시작할 때처럼 식어 있고 원점을 새로 잡았어야 합니다. 보정량은 0으로 돌아갑니다.</translation>
        </message>
        <message>
            <source>Leave it</source>
            <translation>그대로 두기</translation>
        </message>
        <message>
            <source>Count from now on</source>
            <translation>지금부터 기준으로</translation>
        </message>
        <message>
            <source>End the session</source>
            <translation>기록 끝내기</translation>
        </message>
        <message>
            <source>Record a session</source>
            <translation>기록 시작</translation>
        </message>
        <message>
            <source>1. End the program. 2. Put the test bar in the spindle and move it between the three gap sensors. 3. Measure: five readings take five seconds.</source>
            <translation>1. 프로그램을 끝내십시오. 2. 테스트 바를 주축에 끼우고 세 갭 센서 사이로 옮기십시오. 3. 측정: 5회 읽는 데 5초 걸립니다.</translation>
        </message>
        <message numerus="yes">
            <source>Recording: %n minutes measured. Let the spindle run as in a day's work; several hours make a good day.</source>
            <translation>
                <numerusform>기록 중: %n분 측정했습니다. 하루 작업처럼 주축을 돌리십시오. 몇 시간이면 좋은 학습 데이터가 됩니다.</numerusform>
            </translation>
        </message>
        <message>
            <source>Measuring …</source>
            <translation>측정 중 …</translation>
        </message>
        <message>
            <source>Measured. If the difference is outside the interval on a machine that is warm, take it over and train again with this state.</source>
            <translation>측정했습니다. 기계가 데워졌는데도 차이가 구간을 벗어나면 측정값을 적용하고 이 상태로 다시 학습하십시오.</translation>
        </message>
        <message>
            <source>inside the interval</source>
            <translation>구간 안</translation>
        </message>
        <message>
            <source>outside the interval</source>
            <translation>구간 밖</translation>
        </message>
        <message>
            <source>Shifts and measurements</source>
            <translation>보정과 측정 이력</translation>
        </message>
        <message>
            <source>time</source>
            <translation>시간</translation>
        </message>
        <message>
            <source>shift X / Y / Z, %1</source>
            <translation>보정량 X / Y / Z, %1</translation>
        </message>
        <message>
            <source>drift X / Y / Z</source>
            <translation>열변위 X / Y / Z</translation>
        </message>
        <message>
            <source>measured X / Y / Z, %1</source>
            <translation>측정 X / Y / Z, %1</translation>
        </message>
        <message>
            <source>predicted X / Y / Z</source>
            <translation>예측 X / Y / Z</translation>
        </message>
        <message>
            <source>Each change of the shift appears here.</source>
            <translation>보정량이 바뀔 때마다 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Each measurement of the origin appears here.</source>
            <translation>원점을 측정할 때마다 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Thermocouples</source>
            <translation>열전대</translation>
        </message>
        <message>
            <source>Sick ones first, then the model's own.</source>
            <translation>이상이 있는 것이 먼저, 다음은 모델이 쓰는 것입니다.</translation>
        </message>
        <message>
            <source>thermocouple</source>
            <translation>열전대</translation>
        </message>
        <message>
            <source>temperature</source>
            <translation>온도</translation>
        </message>
        <message>
            <source>state</source>
            <translation>상태</translation>
        </message>
        <message>
            <source>used</source>
            <translation>사용</translation>
        </message>
        <message>
            <source>Error over the work space</source>
            <translation>작업 공간의 오차</translation>
        </message>
        <message>
            <source>From the machine's measured error elements, against the corner X0 Y0 of the table; the darker the larger. Independent of the drift with time.</source>
            <translation>측정한 기계 오차 요소에서 계산한, 테이블 모서리 X0 Y0 기준 오차입니다. 진할수록 큽니다. 시간에 따른 열변위와는 별개입니다.</translation>
        </message>
        <message>
            <source>The error elements of this machine have not been measured.</source>
            <translation>이 기계의 오차 요소는 측정되지 않았습니다.</translation>
        </message>
        <message>
            <source>Exact, at Z %1; the first-order formula differs by at most %2.</source>
            <translation>Z %1에서의 정확한 값입니다. 1차 식과의 차이는 최대 %2입니다.</translation>
        </message>
        <message>
            <source>Limits and warm-up</source>
            <translation>한계와 예열</translation>
        </message>
        <message>
            <source>Use</source>
            <translation>사용</translation>
        </message>
        <message>
            <source>the model learns from every measurement by itself</source>
            <translation>모델이 모든 측정값을 스스로 학습합니다</translation>
        </message>
        <message>
            <source>Measured and learnt from. Today differs from the days trained on: measure every hour.</source>
            <translation>측정하고 학습했습니다. 오늘은 학습한 날들과 다릅니다: 매시간 측정하십시오.</translation>
        </message>
        <message>
            <source>Measured and learnt from: the coefficients of today follow from the next minute on.</source>
            <translation>측정하고 학습했습니다: 다음 1분부터 오늘의 계수에 반영됩니다.</translation>
        </message>
        <message>
            <source>Reason for the change</source>
            <translation>변경 사유</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>사유를 입력하십시오</translation>
        </message>
        <message>
            <source>The last part as a measurement</source>
            <translation>직전 공작물을 측정으로 사용</translation>
        </message>
        <message>
            <source>A good part carries what was left of the drift when it was finished. Enter by how much it is off, at the temperature it was cut at; leave empty what was not measured. Each part counts once.</source>
            <translation>양품에는 완성 시점에 남아 있던 열변위가 그대로 남습니다. 가공 당시 온도에서 얼마나 벗어났는지 입력하고, 측정하지 않은 값은 비워 두십시오. 공작물 하나는 한 번만 반영됩니다.</translation>
        </message>
        <message>
            <source>Take as a measurement</source>
            <translation>측정으로 반영</translation>
        </message>
        <message>
            <source>no part finished since the reference</source>
            <translation>기준 이후 완성된 공작물이 없습니다</translation>
        </message>
        <message>
            <source>enter what was measured</source>
            <translation>측정한 값을 입력하십시오</translation>
        </message>
        <message>
            <source>A part is finished that has not been measured yet.</source>
            <translation>완성된 공작물이 있으며 아직 측정하지 않았습니다.</translation>
        </message>
        <message>
            <source>There is no finished part to measure: cut one, then measure it.</source>
            <translation>측정할 완성 공작물이 없습니다. 하나를 가공한 뒤 측정하십시오.</translation>
        </message>
        <message>
            <source>By a measured part</source>
            <translation>측정한 공작물로</translation>
        </message>
        <message>
            <source>%1, part</source>
            <translation>%1, 공작물</translation>
        </message>
        <message>
            <source>The shift moves only between parts</source>
            <translation>공작물 사이에서만 원점 보정</translation>
        </message>
        <message>
            <source>The shift follows while a part is cut</source>
            <translation>가공 중에도 원점 보정</translation>
        </message>
        <message>
            <source>left in a part</source>
            <translation>공작물에 남는 오차</translation>
        </message>
        <message>
            <source>The new limits are stored and hold from now on.</source>
            <translation>새 한계를 저장했으며 지금부터 적용됩니다.</translation>
        </message>
        <message>
            <source>Left out by %1: %2</source>
            <translation>%1 님이 제외: %2</translation>
        </message>
        <message>
            <source>out</source>
            <translation>제외</translation>
        </message>
        <message>
            <source>Reason to leave the touched day out, or to take it in again</source>
            <translation>누른 날을 제외하거나 다시 포함하는 사유</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>다시 포함</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>제외</translation>
        </message>
        <message>
            <source>touch a day first</source>
            <translation>먼저 날을 누르십시오</translation>
        </message>
    </context>
    <context>
    <name>ThermalTexts</name>
        <message>
            <source>healthy</source>
            <translation>정상</translation>
        </message>
        <message>
            <source>suspect</source>
            <translation>의심</translation>
        </message>
        <message>
            <source>open</source>
            <translation>단선</translation>
        </message>
        <message>
            <source>shorted</source>
            <translation>단락</translation>
        </message>
        <message>
            <source>stuck</source>
            <translation>고착</translation>
        </message>
        <message>
            <source>noisy</source>
            <translation>잡음</translation>
        </message>
        <message>
            <source>jumped away</source>
            <translation>값이 튐</translation>
        </message>
        <message>
            <source>disagrees</source>
            <translation>이웃과 불일치</translation>
        </message>
        <message>
            <source>no reading</source>
            <translation>읽히지 않음</translation>
        </message>
        <message>
            <source>%1 min</source>
            <translation>%1분</translation>
        </message>
        <message>
            <source>Ready for %1</source>
            <translation>%1 가공 준비 완료</translation>
        </message>
        <message>
            <source>Ready for %1 in %2</source>
            <translation>%2 뒤 %1 가공 준비 완료</translation>
        </message>
        <message>
            <source>Interval wider than %1: measure the origin</source>
            <translation>구간이 %1보다 넓습니다. 원점을 측정하십시오</translation>
        </message>
        <message>
            <source>Warm-up: %1 left</source>
            <translation>예열: %1 남음</translation>
        </message>
        <message>
            <source>Readiness is known after 20 min of prediction</source>
            <translation>예측 20분 뒤에 준비 시각을 알 수 있습니다</translation>
        </message>
        <message>
            <source>Drift, %1</source>
            <translation>열변위, %1</translation>
        </message>
        <message>
            <source>not judged</source>
            <translation>미판정</translation>
        </message>
        <message>
            <source>good, within %1</source>
            <translation>양호, %1 이내</translation>
        </message>
        <message>
            <source>out of %1</source>
            <translation>%1 벗어남</translation>
        </message>
    </context>
    <context>
    <name>ToolMemory</name>
        <message>
            <source>left out by %1: %2</source>
            <translation>제외함 (%1): %2</translation>
        </message>
        <message>
            <source>Tools before</source>
            <translation>이전 공구</translation>
        </message>
        <message>
            <source>A new tool begins from tools of its radius and flutes. There are none yet.</source>
            <translation>새 공구는 반경과 날 수가 같은 이전 공구에서 시작합니다. 아직 없습니다.</translation>
        </message>
        <message>
            <source>Reason</source>
            <translation>사유</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>다시 포함</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>제외</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>%1, %2 parts: %3 %4 N/mm, %5 %6</source>
            <comment>part type, parts, two figures of a tool with their names</comment>
            <translation>%1, 공작물 %2개: %3 %4 N/mm, %5 %6</translation>
        </message>
        <message>
            <source>Begins from %1 tools before: %2 %3 N/mm (%4 to %5)</source>
            <comment>how many, name, value, interval</comment>
            <translation>이전 공구 %1개에서 시작: %2 %3 N/mm (%4 ~ %5)</translation>
        </message>
        <message>
            <source>, %1 %2 ± %3</source>
            <comment>name and value expected of the first part</comment>
            <translation>, %1 %2 ± %3</translation>
        </message>
        <message>
            <source>What tools before count for is kept.</source>
            <translation>이전 공구의 반영 여부를 저장했습니다.</translation>
        </message>
    </context>
    <context>
    <name>Tools</name>
        <message>
            <source>%1 of %2 parts</source>
            <translation>%2개 중 %1개</translation>
        </message>
        <message>
            <source>%1 parts, no life is set</source>
            <translation>%1개, 수명 미설정</translation>
        </message>
        <message>
            <source>changed %1 by %2</source>
            <translation>교환: %1, %2</translation>
        </message>
        <message>
            <source>Life of the tool: %1</source>
            <translation>공구 수명: %1</translation>
        </message>
        <message>
            <source>Parts that a tool is used for. At nine tenths of them Kerf says so. 0: no life is set.</source>
            <translation>공구 하나로 가공할 개수입니다. 그 9할에서 Kerf가 알립니다. 0: 수명 미설정.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>A life is a whole number of parts.</source>
            <translation>수명은 공작물 개수(정수)입니다.</translation>
        </message>
        <message>
            <source>The life is kept.</source>
            <translation>수명을 저장했습니다.</translation>
        </message>
        <message>
            <source>Keep it</source>
            <translation>저장</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>공구</translation>
        </message>
        <message>
            <source>Parts are counted from the last change. Say so when a new tool or insert is in: wear and what the loop has learnt of the old one end with it.</source>
            <translation>마지막 교환부터 센 개수입니다. 새 공구나 인서트를 끼우면 알려 주십시오. 이전 공구의 마모와 학습 내용은 거기서 끝납니다.</translation>
        </message>
        <message>
            <source>Life</source>
            <translation>수명</translation>
        </message>
        <message>
            <source>New tool</source>
            <translation>새 공구</translation>
        </message>
        <message>
            <source>A new tool is in: its parts are counted from here.</source>
            <translation>새 공구: 지금부터 개수를 셉니다.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
    </context>
    <context>
    <name>TurningTexts</name>
        <message>
            <source>Open</source>
            <comment>turning controller</comment>
            <translation>개루프</translation>
        </message>
        <message>
            <source>Paper's PI</source>
            <comment>turning controller</comment>
            <translation>논문의 PI</translation>
        </message>
        <message>
            <source>Tuned PI</source>
            <comment>turning controller</comment>
            <translation>조정한 PI</translation>
        </message>
        <message>
            <source>Tones</source>
            <comment>turning controller</comment>
            <translation>주파수 상쇄</translation>
        </message>
        <message>
            <source>out of the cut</source>
            <translation>절삭 밖</translation>
        </message>
        <message>
            <source>first revolution</source>
            <translation>첫 회전</translation>
        </message>
        <message>
            <source>cutting</source>
            <translation>절삭 중</translation>
        </message>
        <message>
            <source>out of the loop</source>
            <translation>루프에서 빠짐</translation>
        </message>
        <message>
            <source>not cutting</source>
            <translation>절삭하지 않음</translation>
        </message>
        <message>
            <source>%1 deep, %2, %3 per revolution, tool radius %4</source>
            <comment>depth, speed, feed, radius</comment>
            <translation>깊이 %1, %2, 회전당 %3, 공구 반경 %4</translation>
        </message>
    </context>
    <context>
    <name>VerdictTexts</name>
        <message>
            <source>good</source>
            <translation>양품</translation>
        </message>
        <message>
            <source>not judged</source>
            <translation>미판정</translation>
        </message>
        <message>
            <source>rework possible</source>
            <translation>재가공 가능</translation>
        </message>
        <message>
            <source>scrap</source>
            <translation>폐기</translation>
        </message>
    </context>
    <context>
    <name>Vocabulary</name>
        <message>
            <source>How the bar bends</source>
            <translation>보링 바의 휨</translation>
        </message>
        <message>
            <source>Estimated law</source>
            <translation>추정한 법칙</translation>
        </message>
        <message>
            <source>by feed</source>
            <translation>이송 영향</translation>
        </message>
        <message>
            <source>by overhang</source>
            <translation>돌출 영향</translation>
        </message>
        <message>
            <source>as a whole</source>
            <translation>전체 크기</translation>
        </message>
        <message>
            <source>Tool: how hard it cuts, per part</source>
            <translation>공구: 공작물별 절삭 부하</translation>
        </message>
        <message>
            <source>Tool: mean ln(C·b) per part</source>
            <translation>공구: 공작물별 평균 ln(C·b)</translation>
        </message>
        <message>
            <source>how hard it cuts</source>
            <translation>절삭 부하</translation>
        </message>
        <message>
            <source>how hard it cuts now</source>
            <translation>현재 절삭 부하</translation>
        </message>
        <message>
            <source>ln(C·b) now</source>
            <translation>현재 ln(C·b)</translation>
        </message>
        <message>
            <source>tool stiffness</source>
            <translation>공구 강성</translation>
        </message>
        <message>
            <source>reserve before it swings, times</source>
            <translation>흔들림까지 여유, 배</translation>
        </message>
        <message>
            <source>gain margin, times</source>
            <translation>게인 여유, 배</translation>
        </message>
        <message>
            <source>unevenness, on average</source>
            <translation>표면 굴곡, 평균</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>RMS</translation>
        </message>
        <message>
            <source>highest to lowest point</source>
            <translation>표면 굴곡, 최대 폭</translation>
        </message>
        <message>
            <source>P-V of a revolution</source>
            <translation>한 회전의 P-V</translation>
        </message>
        <message>
            <source>unevenness without the trim</source>
            <translation>보정 없을 때 굴곡</translation>
        </message>
        <message>
            <source>RMS without the trim</source>
            <translation>보정 없을 때 RMS</translation>
        </message>
        <message>
            <source>Reserves and trim</source>
            <translation>여유와 보정</translation>
        </message>
        <message>
            <source>Loop margins and trim</source>
            <translation>루프 여유와 보정</translation>
        </message>
        <message>
            <source>may be stronger, times</source>
            <translation>세기 여유, 배</translation>
        </message>
        <message>
            <source>gain, times</source>
            <translation>게인, 배</translation>
        </message>
        <message>
            <source>may be shifted by</source>
            <translation>어긋남 여유</translation>
        </message>
        <message>
            <source>phase</source>
            <translation>위상</translation>
        </message>
        <message>
            <source>may come later by</source>
            <translation>지연 여유</translation>
        </message>
        <message>
            <source>more delay</source>
            <translation>추가 지연</translation>
        </message>
        <message>
            <source>distance from ringing</source>
            <translation>떨림까지 거리</translation>
        </message>
        <message>
            <source>smallest |1 + L|</source>
            <translation>최소 |1 + L|</translation>
        </message>
        <message>
            <source>share of the last force</source>
            <translation>직전 힘의 몫</translation>
        </message>
        <message>
            <source>force of the depth now</source>
            <translation>현재 깊이의 힘</translation>
        </message>
        <message>
            <source>force of the depth before</source>
            <translation>직전 깊이의 힘</translation>
        </message>
        <message>
            <source>doubt, log</source>
            <translation>불확실성, 로그</translation>
        </message>
        <message>
            <source>covariance, log</source>
            <translation>공분산, 로그</translation>
        </message>
        <message>
            <source>Drift of the origin, predicted</source>
            <translation>원점 열변위 예측</translation>
        </message>
        <message>
            <source>Drift δ̂ of the origin, ± 1.96 σ</source>
            <translation>원점 열변위 δ̂, ± 1.96 σ</translation>
        </message>
        <message>
            <source>drift</source>
            <translation>열변위</translation>
        </message>
        <message>
            <source>line: predicted, band: 95 % interval, dots: measured</source>
            <translation>선: 예측, 띠: 95 % 구간, 점: 측정</translation>
        </message>
        <message>
            <source>line: δ̂, band: ± 1.96 σ, dots: δ measured</source>
            <translation>선: δ̂, 띠: ± 1.96 σ, 점: 측정한 δ</translation>
        </message>
        <message>
            <source>a few thermocouples, straight lines</source>
            <translation>열전대 몇 개, 직선식</translation>
        </message>
        <message>
            <source>regression on few sensors</source>
            <translation>소수 센서 회귀</translation>
        </message>
        <message>
            <source>all days together, and today</source>
            <translation>모든 날과 오늘을 함께</translation>
        </message>
        <message>
            <source>hierarchical over days</source>
            <translation>일별 계층 모델</translation>
        </message>
        <message>
            <source>network of thermocouples</source>
            <translation>열전대 신경망</translation>
        </message>
        <message>
            <source>network, guarded</source>
            <translation>신경망, 보호형</translation>
        </message>
        <message>
            <source>network, as first published</source>
            <translation>신경망, 처음 발표된 형태</translation>
        </message>
        <message>
            <source>network, as printed</source>
            <translation>신경망, 논문 그대로</translation>
        </message>
        <message>
            <source>How spindle and Z are matched</source>
            <translation>주축과 Z축 맞춤</translation>
        </message>
        <message>
            <source>Gains</source>
            <translation>게인</translation>
        </message>
        <message>
            <source>spindle, how firm, 1/s</source>
            <translation>주축 추종 세기, 1/s</translation>
        </message>
        <message>
            <source>spindle Kp, 1/s</source>
            <translation>주축 Kp, 1/s</translation>
        </message>
        <message>
            <source>Z, how firm, 1/s</source>
            <translation>Z축 추종 세기, 1/s</translation>
        </message>
        <message>
            <source>Z Kp, 1/s</source>
            <translation>Z Kp, 1/s</translation>
        </message>
        <message>
            <source>Z, ahead with speed</source>
            <translation>Z축 속도 선행</translation>
        </message>
        <message>
            <source>Z speed FF</source>
            <translation>Z 속도 FF</translation>
        </message>
        <message>
            <source>Z, ahead with accel.</source>
            <translation>Z축 가속 선행</translation>
        </message>
        <message>
            <source>Z accel. FF</source>
            <translation>Z 가속 FF</translation>
        </message>
        <message>
            <source>How far Z is off the thread, %1, over spindle revolutions in and out</source>
            <translation>주축 회전에 따른 나사 어긋남, %1, 진입과 후퇴</translation>
        </message>
        <message>
            <source>Contour error E_r, %1, over spindle revolutions in and out</source>
            <translation>주축 회전에 따른 윤곽 오차 E_r, %1, 진입과 후퇴</translation>
        </message>
        <message>
            <source>errors added up, %1</source>
            <translation>오차 합, %1</translation>
        </message>
        <message>
            <source>SAEC = Σ |E_r|, %1</source>
            <translation>SAEC = Σ |E_r|, %1</translation>
        </message>
        <message>
            <source>widest error in the work, %1</source>
            <translation>가공 구간 최대 오차 폭, %1</translation>
        </message>
        <message>
            <source>E_r p-p in the work, %1</source>
            <translation>가공 구간 E_r p-p, %1</translation>
        </message>
    </context>
    <context>
    <name>Words</name>
        <message>
            <source>Alarm %1, which this console does not know</source>
            <translation>이 콘솔이 모르는 알람 %1</translation>
        </message>
        <message>
            <source>Note the number and call service.</source>
            <translation>번호를 적어 두고 서비스에 연락하십시오.</translation>
        </message>
        <message>
            <source>off</source>
            <translation>꺼짐</translation>
        </message>
        <message>
            <source>advising</source>
            <translation>추천 중</translation>
        </message>
        <message>
            <source>controlling</source>
            <translation>제어 중</translation>
        </message>
        <message>
            <source>limited</source>
            <translation>한계</translation>
        </message>
        <message>
            <source>held</source>
            <translation>홀드</translation>
        </message>
        <message>
            <source>faulted</source>
            <translation>고장</translation>
        </message>
        <message>
            <source>advise</source>
            <translation>추천</translation>
        </message>
        <message>
            <source>control</source>
            <translation>제어</translation>
        </message>
        <message>
            <source>process %1</source>
            <translation>공정 %1</translation>
        </message>
    </context>
    <context>
    <name>engine</name>
        <message>
            <source>%1 % of the samples are missing: this tap does not count, repeat it.</source>
            <translation>샘플의 %1 %가 빠졌습니다. 이 탭은 무효이니 다시 하십시오.</translation>
        </message>
        <message>
            <source>%1 % of the samples are missing; a record with more than %2 % does not count.</source>
            <translation>샘플의 %1 %가 빠졌습니다. %2 %를 넘게 빠진 기록은 무효입니다.</translation>
        </message>
        <message>
            <source>%1 measurements were accepted, %2 are stored.</source>
            <translation>측정값 %1개를 받았으나 저장된 것은 %2개입니다.</translation>
        </message>
        <message>
            <source>%1 must be from %2 to %3.</source>
            <translation>%1: %2에서 %3 사이여야 합니다.</translation>
        </message>
        <message>
            <source>A blank profile needs from 1 to %1 steps.</source>
            <translation>소재 형상은 1단에서 %1단까지입니다.</translation>
        </message>
        <message>
            <source>A correction needs a reason.</source>
            <translation>수정하려면 사유가 필요합니다.</translation>
        </message>
        <message>
            <source>A deflection must be a number above 0 mm.</source>
            <translation>처짐은 0 mm보다 큰 수여야 합니다.</translation>
        </message>
        <message>
            <source>A deflection of %1 mm was expected, the entry means %2 mm. Measure again or confirm.</source>
            <translation>예상 처짐은 %1 mm인데 입력값대로면 %2 mm입니다. 다시 측정하거나 확인하십시오.</translation>
        </message>
        <message>
            <source>A diameter is a number above zero.</source>
            <translation>지름은 0보다 큰 수여야 합니다.</translation>
        </message>
        <message>
            <source>A part is being cut.</source>
            <translation>공작물을 가공하고 있습니다.</translation>
        </message>
        <message>
            <source>A real machine runs at its own speed.</source>
            <translation>실제 기계는 자기 속도로만 움직입니다.</translation>
        </message>
        <message>
            <source>A revolution has %1 samples; expected 2 to %2.</source>
            <translation>1회전에 샘플이 %1개입니다. 2개에서 %2개 사이여야 합니다.</translation>
        </message>
        <message>
            <source>A tone is at %1 Hz; expected above 0 and below %2 Hz.</source>
            <translation>주파수가 %1 Hz입니다. 0보다 크고 %2 Hz보다 작아야 합니다.</translation>
        </message>
        <message>
            <source>All %1 taps are used.</source>
            <translation>탭 %1회를 모두 사용했습니다.</translation>
        </message>
        <message>
            <source>All loops are held by the operator; the last offset stays.</source>
            <translation>작업자가 모든 루프를 홀드했습니다. 마지막 보정값은 유지됩니다.</translation>
        </message>
        <message>
            <source>All loops are held: release the hold first.</source>
            <translation>모든 루프가 홀드 상태입니다. 먼저 홀드를 해제하십시오.</translation>
        </message>
        <message>
            <source>An infeed of %1 um per revolution leaves no overlap; at this depth at most %2 um.</source>
            <translation>회전당 이송 %1 um로는 중첩이 생기지 않습니다. 이 깊이에서는 최대 %2 um입니다.</translation>
        </message>
        <message>
            <source>An overhang must be a number above 0 mm.</source>
            <translation>돌출 길이는 0 mm보다 큰 수여야 합니다.</translation>
        </message>
        <message>
            <source>Another Kerf is already working with this data file.</source>
            <translation>다른 Kerf가 이미 이 데이터 파일을 쓰고 있습니다.</translation>
        </message>
        <message>
            <source>Audit entry %1 was changed after it was written.</source>
            <translation>감사 기록 %1번이 기록된 뒤에 바뀌었습니다.</translation>
        </message>
        <message>
            <source>Blank step %1 must end after it begins.</source>
            <translation>소재 형상 %1단은 시작점보다 뒤에서 끝나야 합니다.</translation>
        </message>
        <message>
            <source>Bringing the data file %1 up to date failed at step %2; it is as it was after step %3, and the copy made before is kept.</source>
            <translation>데이터 파일 %1을(를) 최신으로 바꾸다가 %2단계에서 실패했습니다. 파일은 %3단계 뒤의 상태 그대로이며 앞서 만든 사본도 남아 있습니다.</translation>
        </message>
        <message>
            <source>Check the spindle encoder. Measure this part at both depths.</source>
            <translation>주축 엔코더를 점검하십시오. 이 공작물은 두 깊이에서 모두 측정하십시오.</translation>
        </message>
        <message>
            <source>Check the spindle's position signal. Measure this part at both depths.</source>
            <translation>주축 위치 신호를 점검하십시오. 이 공작물은 두 깊이에서 모두 측정하십시오.</translation>
        </message>
        <message>
            <source>Compare the next part with its prediction. Keep the data file for the service.</source>
            <translation>다음 공작물을 예측값과 비교하십시오. 데이터 파일은 서비스용으로 보관하십시오.</translation>
        </message>
        <message>
            <source>Emergency stop</source>
            <translation>비상정지</translation>
        </message>
        <message>
            <source>Emergency stop: the control has stopped the machine.</source>
            <translation>비상정지: 제어기가 기계를 세웠습니다.</translation>
        </message>
        <message>
            <source>End other programs. See Diagnostics for cycle times and how to allow real-time scheduling.</source>
            <translation>다른 프로그램을 끝내십시오. 사이클 시간과 실시간 스케줄링 허용 방법은 진단 화면에 있습니다.</translation>
        </message>
        <message>
            <source>Finished parts are not being stored</source>
            <translation>끝난 공작물이 저장되지 않습니다</translation>
        </message>
        <message>
            <source>Free disk space or end the program that locks the file. Storing goes on by itself.</source>
            <translation>디스크 공간을 비우거나 파일을 잠근 프로그램을 끝내십시오. 저장은 저절로 이어집니다.</translation>
        </message>
        <message>
            <source>Height of blank step %1 must be from 0 to %2 mm.</source>
            <translation>소재 형상 %1단의 높이는 0에서 %2 mm 사이여야 합니다.</translation>
        </message>
        <message>
            <source>Held again since the release was asked.</source>
            <translation>해제를 요청한 뒤에 다시 홀드되었습니다.</translation>
        </message>
        <message>
            <source>Least error expected at a gain of %1 1/s: %2 mm instead of %3 mm.</source>
            <translation>게인 %1 1/s에서 오차가 가장 작을 것입니다: %3 mm 대신 %2 mm.</translation>
        </message>
        <message>
            <source>Loops react later than designed. Feed and offsets stay inside their limits.</source>
            <translation>루프가 설계보다 늦게 반응합니다. 이송과 보정은 한계 안에 머뭅니다.</translation>
        </message>
        <message>
            <source>Matched gain %1 1/s, feed-forward %2 and a learned trim: %3 mm expected.</source>
            <translation>맞춘 게인 %1 1/s, 피드포워드 %2, 학습한 보정: 예상 오차 %3 mm.</translation>
        </message>
        <message>
            <source>Measurement %1 differs from what was logged when it was accepted.</source>
            <translation>측정값 %1번이 받을 때 남긴 기록과 다릅니다.</translation>
        </message>
        <message>
            <source>Measurement %1 is already in the lot.</source>
            <translation>측정값 %1번은 이미 로트에 있습니다.</translation>
        </message>
        <message>
            <source>Measurement %1 is not in use any more.</source>
            <translation>측정값 %1번은 더 이상 쓰이지 않습니다.</translation>
        </message>
        <message>
            <source>No connection to the machine</source>
            <translation>기계와 연결되지 않음</translation>
        </message>
        <message>
            <source>No feed schedule is loaded: choose a part type and a lot first.</source>
            <translation>이송 계획이 없습니다. 먼저 품종과 로트를 고르십시오.</translation>
        </message>
        <message>
            <source>No feed schedule is loaded: this bore is cut at its programmed feed.</source>
            <translation>이송 계획이 없어 이 내경은 프로그램 이송으로 가공합니다.</translation>
        </message>
        <message>
            <source>No tone is given; expected one frequency in Hz or more.</source>
            <translation>주파수가 없습니다. Hz 단위로 하나 이상 필요합니다.</translation>
        </message>
        <message>
            <source>Not fitted yet.</source>
            <translation>아직 장착되지 않았습니다.</translation>
        </message>
        <message>
            <source>Part %1 has all of its %2 measurements.</source>
            <translation>%1번 공작물은 측정 %2개가 모두 끝났습니다.</translation>
        </message>
        <message>
            <source>Part %1 has been measured at %2 mm; correct that value instead.</source>
            <translation>%1번 공작물은 %2 mm에서 이미 측정했습니다. 그 값을 수정하십시오.</translation>
        </message>
        <message>
            <source>Part %1 has no known feed at %2 mm.</source>
            <translation>%1번 공작물은 %2 mm에서의 이송을 알 수 없습니다.</translation>
        </message>
        <message>
            <source>Part %1 has not been cut yet.</source>
            <translation>%1번 공작물은 아직 가공하지 않았습니다.</translation>
        </message>
        <message>
            <source>Part %1 is already in the lot.</source>
            <translation>%1번 공작물은 이미 로트에 있습니다.</translation>
        </message>
        <message>
            <source>Reading or writing the data file failed: check the disk.</source>
            <translation>데이터 파일을 읽거나 쓰지 못했습니다. 디스크를 점검하십시오.</translation>
        </message>
        <message>
            <source>Ready: the next bore is cut at its programmed feed.</source>
            <translation>준비됨: 다음 내경은 프로그램 이송으로 가공합니다.</translation>
        </message>
        <message>
            <source>Ready: the next bore is cut with the schedule shown.</source>
            <translation>준비됨: 다음 내경은 표시된 이송 계획으로 가공합니다.</translation>
        </message>
        <message>
            <source>Refine the learned trim: %1 mm expected instead of %2 mm.</source>
            <translation>학습한 보정을 다듬습니다: %2 mm 대신 %1 mm 예상.</translation>
        </message>
        <message>
            <source>Sampling is uneven: %1 ms between samples %2 and the next, %3 ms elsewhere.</source>
            <translation>샘플 간격이 고르지 않습니다: %2번 샘플과 다음 사이 %1 ms, 다른 곳은 %3 ms.</translation>
        </message>
        <message>
            <source>Schedule %1 of this lot is not stored.</source>
            <translation>이 로트의 이송 계획 %1번이 저장되어 있지 않습니다.</translation>
        </message>
        <message>
            <source>Set the feed knob to 100 %, or accept the deviation.</source>
            <translation>이송 오버라이드를 100 %에 맞추거나 편차를 받아들이십시오.</translation>
        </message>
        <message>
            <source>Sign on first: a measurement needs a name.</source>
            <translation>먼저 로그인하십시오. 측정값에는 이름이 필요합니다.</translation>
        </message>
        <message>
            <source>Sign on first: the audit log needs a name.</source>
            <translation>먼저 로그인하십시오. 감사 기록에는 이름이 필요합니다.</translation>
        </message>
        <message>
            <source>Simulation speed must be from 1 to 1000, or 0 for as fast as possible.</source>
            <translation>시뮬레이션 속도는 1에서 1000, 또는 최대 속도인 0이어야 합니다.</translation>
        </message>
        <message>
            <source>Spindle overhang unknown</source>
            <translation>주축 돌출 길이를 알 수 없음</translation>
        </message>
        <message>
            <source>Spindle speed unknown</source>
            <translation>주축 회전수를 알 수 없음</translation>
        </message>
        <message>
            <source>Sum of errors changed by %1 mm: gain from %2 to %3 1/s.</source>
            <translation>오차 합이 %1 mm 바뀌었습니다: 게인을 %2에서 %3 1/s로 바꿉니다.</translation>
        </message>
        <message>
            <source>Switched off.</source>
            <translation>꺼져 있습니다.</translation>
        </message>
        <message>
            <source>The audit log is broken before entry %1: entries are missing.</source>
            <translation>감사 기록이 %1번 앞에서 끊겼습니다. 빠진 기록이 있습니다.</translation>
        </message>
        <message>
            <source>The backup %1 could not be written completely.</source>
            <translation>백업 %1을(를) 끝까지 쓰지 못했습니다.</translation>
        </message>
        <message>
            <source>The best feed at %1 mm overhang lies outside %2 to %3 mm/rev; it sits at the limit.</source>
            <translation>돌출 %1 mm에서 가장 좋은 이송이 %2~%3 mm/rev를 벗어나 한계에 머뭅니다.</translation>
        </message>
        <message>
            <source>The best feed lies outside %1 to %2 mm/rev: the feed sits at the limit.</source>
            <translation>가장 좋은 이송이 %1~%2 mm/rev를 벗어나 한계에 머뭅니다.</translation>
        </message>
        <message>
            <source>The best gain no longer moves: %1 1/s.</source>
            <translation>최적 게인이 더 움직이지 않습니다: %1 1/s.</translation>
        </message>
        <message>
            <source>The bore is cut with another feed than planned. The estimate uses the feed really cut.</source>
            <translation>내경이 계획과 다른 이송으로 가공됩니다. 추정에는 실제 가공 이송을 씁니다.</translation>
        </message>
        <message>
            <source>The boring loop does not know this command.</source>
            <translation>보링 루프가 모르는 명령입니다.</translation>
        </message>
        <message>
            <source>The boring program needs feed, speed and overhangs above zero, the end deeper than the start.</source>
            <translation>보링 프로그램에는 0보다 큰 이송, 회전수, 돌출 길이가 필요하고 끝은 시작보다 깊어야 합니다.</translation>
        </message>
        <message>
            <source>The command was not sent: the engine has not taken the earlier ones yet. Try again.</source>
            <translation>명령을 보내지 못했습니다. 엔진이 앞선 명령을 아직 받지 않았습니다. 다시 해 보십시오.</translation>
        </message>
        <message>
            <source>The control is still busy with earlier commands.</source>
            <translation>제어기가 아직 앞선 명령을 처리하고 있습니다.</translation>
        </message>
        <message>
            <source>The control no longer answers: cable, network or the control itself.</source>
            <translation>제어기가 응답하지 않습니다: 케이블, 네트워크 또는 제어기 자체.</translation>
        </message>
        <message>
            <source>The control refused the command: is it switched on, homed and idle?</source>
            <translation>제어기가 명령을 거부했습니다. 전원이 켜져 있고 원점 복귀를 마쳤으며 대기 중입니까?</translation>
        </message>
        <message>
            <source>The control takes no commands: linuxcncrsh does not answer.</source>
            <translation>제어기가 명령을 받지 않습니다. linuxcncrsh가 응답하지 않습니다.</translation>
        </message>
        <message>
            <source>The data file %1 cannot be read: check its permissions.</source>
            <translation>데이터 파일 %1을(를) 읽을 수 없습니다. 권한을 확인하십시오.</translation>
        </message>
        <message>
            <source>The data file %1 has version %2, written by a newer Kerf; this one knows up to %3. Install the newer program; the file was left as it is.</source>
            <translation>데이터 파일 %1은(는) 더 새로운 Kerf가 쓴 버전 %2입니다. 이 프로그램은 %3까지 압니다. 새 프로그램을 설치하십시오. 파일은 그대로 두었습니다.</translation>
        </message>
        <message>
            <source>The data file %1 is damaged; it was left as it is. Go on with the newest backup.</source>
            <translation>데이터 파일 %1이(가) 손상되어 그대로 두었습니다. 가장 새로운 백업으로 계속하십시오.</translation>
        </message>
        <message>
            <source>The data file cannot be opened: check the folder and its permissions.</source>
            <translation>데이터 파일을 열 수 없습니다. 폴더와 권한을 확인하십시오.</translation>
        </message>
        <message>
            <source>The data file cannot be written: it, or its folder, is read-only.</source>
            <translation>데이터 파일에 쓸 수 없습니다. 파일이나 폴더가 읽기 전용입니다.</translation>
        </message>
        <message>
            <source>The data file is damaged: go on with the newest backup and keep this file.</source>
            <translation>데이터 파일이 손상되었습니다. 가장 새로운 백업으로 계속하고 이 파일은 보관하십시오.</translation>
        </message>
        <message>
            <source>The data file is in use by another program; try again in a moment.</source>
            <translation>다른 프로그램이 데이터 파일을 쓰고 있습니다. 잠시 뒤 다시 해 보십시오.</translation>
        </message>
        <message>
            <source>The data file is not a Kerf database.</source>
            <translation>데이터 파일이 Kerf 데이터베이스가 아닙니다.</translation>
        </message>
        <message>
            <source>The data file refused the entry: it contradicts what is already stored.</source>
            <translation>데이터 파일이 입력을 거부했습니다. 이미 저장된 것과 맞지 않습니다.</translation>
        </message>
        <message>
            <source>The data file refused the request (code %1).</source>
            <translation>데이터 파일이 요청을 거부했습니다(코드 %1).</translation>
        </message>
        <message>
            <source>The data folder cannot be made; choose another one with --data.</source>
            <translation>데이터 폴더를 만들 수 없습니다. --data로 다른 폴더를 고르십시오.</translation>
        </message>
        <message>
            <source>The database does not take records: disk full, or the file is locked.</source>
            <translation>데이터베이스가 기록을 받지 않습니다. 디스크가 가득 찼거나 파일이 잠겨 있습니다.</translation>
        </message>
        <message>
            <source>The depth of cut is %1 um; expected above 0, at most the tool radius %2 um.</source>
            <translation>절삭 깊이가 %1 um입니다. 0보다 크고 공구 반경 %2 um 이하여야 합니다.</translation>
        </message>
        <message>
            <source>The disk is full: nothing can be stored until space is made.</source>
            <translation>디스크가 가득 찼습니다. 공간을 비울 때까지 저장할 수 없습니다.</translation>
        </message>
        <message>
            <source>The emergency stop of the machine is pressed.</source>
            <translation>기계의 비상정지가 눌려 있습니다.</translation>
        </message>
        <message>
            <source>The engine misses its deadlines</source>
            <translation>엔진이 제때 돌지 못함</translation>
        </message>
        <message>
            <source>The entry is not a number.</source>
            <translation>입력이 숫자가 아닙니다.</translation>
        </message>
        <message>
            <source>The estimate differs from the stored one</source>
            <translation>추정값이 저장된 것과 다름</translation>
        </message>
        <message>
            <source>The estimated exponent α = %1 is outside %2 to %3 and was clipped.</source>
            <translation>추정한 지수 α = %1이(가) %2~%3을 벗어나 잘라 냈습니다.</translation>
        </message>
        <message>
            <source>The extra delay is %1 samples; expected 0 or 1.</source>
            <translation>추가 지연이 %1샘플입니다. 0 또는 1이어야 합니다.</translation>
        </message>
        <message>
            <source>The feed does not follow the schedule</source>
            <translation>이송이 계획을 따르지 않음</translation>
        </message>
        <message>
            <source>The feed follows the schedule along the bore.</source>
            <translation>내경을 따라 이송이 계획대로 움직입니다.</translation>
        </message>
        <message>
            <source>The feed schedule has a value outside its range; the last one stays.</source>
            <translation>이송 계획에 범위를 벗어난 값이 있어 앞선 계획을 유지합니다.</translation>
        </message>
        <message>
            <source>The file %1 exists already; a backup never overwrites.</source>
            <translation>파일 %1이(가) 이미 있습니다. 백업은 덮어쓰지 않습니다.</translation>
        </message>
        <message>
            <source>The file %1 is a database of another program; it was left as it is.</source>
            <translation>파일 %1은(는) 다른 프로그램의 데이터베이스여서 그대로 두었습니다.</translation>
        </message>
        <message>
            <source>The file %1 is not a database; it was left as it is.</source>
            <translation>파일 %1은(는) 데이터베이스가 아니어서 그대로 두었습니다.</translation>
        </message>
        <message>
            <source>The finished part is kept in memory. No new part can be started.</source>
            <translation>끝난 공작물의 기록은 메모리에 남아 있습니다. 새 공작물을 시작할 수 없습니다.</translation>
        </message>
        <message>
            <source>The forgetting factor is %1; expected 0.5 to 1.</source>
            <translation>망각 계수가 %1입니다. 0.5에서 1 사이여야 합니다.</translation>
        </message>
        <message>
            <source>The gain error is %1; expected above 0, at most 10.</source>
            <translation>게인 오차가 %1입니다. 0보다 크고 10 이하여야 합니다.</translation>
        </message>
        <message>
            <source>The infeed is %1 um per revolution; expected 0 or more.</source>
            <translation>회전당 이송이 %1 um입니다. 0 이상이어야 합니다.</translation>
        </message>
        <message>
            <source>The initial covariance is %1; expected above 0, at most 1e9.</source>
            <translation>초기 공분산이 %1입니다. 0보다 크고 1e9 이하여야 합니다.</translation>
        </message>
        <message>
            <source>The last part is not stored yet: no new part until it is.</source>
            <translation>직전 공작물이 아직 저장되지 않았습니다. 저장될 때까지 새 공작물을 시작할 수 없습니다.</translation>
        </message>
        <message>
            <source>The length of a blank segment must be above 0 and at most %1 mm.</source>
            <translation>소재 구간의 길이는 0보다 크고 %1 mm 이하여야 합니다.</translation>
        </message>
        <message>
            <source>The limit of the forgetting is %1; expected 0 or more.</source>
            <translation>망각 한계가 %1입니다. 0 이상이어야 합니다.</translation>
        </message>
        <message>
            <source>The lot was computed again from its stored measurements and gave another state than the one stored with the last of them: another version of the program, or a changed file.</source>
            <translation>저장된 측정값으로 로트를 다시 계산했더니 마지막 측정값과 함께 저장된 상태와 다릅니다. 프로그램 버전이 다르거나 파일이 바뀌었습니다.</translation>
        </message>
        <message>
            <source>The machine is not ready.</source>
            <translation>기계가 준비되지 않았습니다.</translation>
        </message>
        <message>
            <source>The machine is switched off.</source>
            <translation>기계 전원이 꺼져 있습니다.</translation>
        </message>
        <message>
            <source>The measurement to be replaced is not stored.</source>
            <translation>대체할 측정값이 저장되어 있지 않습니다.</translation>
        </message>
        <message>
            <source>The newly computed estimate and feed schedule are used.</source>
            <translation>새로 계산한 추정값과 이송 계획을 씁니다.</translation>
        </message>
        <message>
            <source>The operator's feed knob, a limit of the control, or its acceleration keeps the feed away from the schedule.</source>
            <translation>작업자의 이송 오버라이드, 제어기의 한계 또는 가속도 때문에 이송이 계획에서 벗어납니다.</translation>
        </message>
        <message>
            <source>The part belongs to no lot: no estimator can learn from it.</source>
            <translation>공작물이 어느 로트에도 속하지 않아 추정에 쓸 수 없습니다.</translation>
        </message>
        <message>
            <source>The part of this measurement is not stored.</source>
            <translation>이 측정값의 공작물이 저장되어 있지 않습니다.</translation>
        </message>
        <message>
            <source>The recipe has no revision %1.</source>
            <translation>레시피에 개정 %1번이 없습니다.</translation>
        </message>
        <message>
            <source>The record has %1 samples; at least %2 are needed.</source>
            <translation>기록에 샘플이 %1개입니다. 적어도 %2개가 필요합니다.</translation>
        </message>
        <message>
            <source>The schedule wants %1 of the programmed feed; this control allows %2.</source>
            <translation>계획은 프로그램 이송의 %1배를 원하지만 이 제어기는 %2배까지 허용합니다.</translation>
        </message>
        <message>
            <source>The spindle cannot bend by %1 mm; its deflection must be above 0. Measure again.</source>
            <translation>주축이 %1 mm 휠 수는 없습니다. 처짐은 0보다 커야 합니다. 다시 측정하십시오.</translation>
        </message>
        <message>
            <source>The spindle position jumps by no whole number of revolutions: counts are lost or the column is not in revolutions.</source>
            <translation>주축 위치가 정수가 아닌 회전만큼 건너뜁니다. 펄스를 놓쳤거나 열의 단위가 회전이 아닙니다.</translation>
        </message>
        <message>
            <source>The spindle speed is %1 rev/s; expected %2 to %3.</source>
            <translation>주축 회전수가 %1 rev/s입니다. %2에서 %3 사이여야 합니다.</translation>
        </message>
        <message>
            <source>The spindle turns %1 rev in the whole record; a tap needs at least one.</source>
            <translation>전체 기록에서 주축이 %1회전합니다. 탭에는 적어도 1회전이 필요합니다.</translation>
        </message>
        <message>
            <source>The spindle turns up to %1 rev between two samples; at most %2 rev: sample faster.</source>
            <translation>두 샘플 사이에 주축이 최대 %1회전합니다. %2회전 이하여야 하니 더 빠르게 샘플링하십시오.</translation>
        </message>
        <message>
            <source>The spindle's speed signal is missing, old or not a number.</source>
            <translation>주축 회전수 신호가 없거나 오래되었거나 숫자가 아닙니다.</translation>
        </message>
        <message>
            <source>The tool radius is %1 um; expected above 0, at most 1000000 um.</source>
            <translation>공구 반경이 %1 um입니다. 0보다 크고 1000000 um 이하여야 합니다.</translation>
        </message>
        <message>
            <source>There is no such alarm.</source>
            <translation>그런 알람이 없습니다.</translation>
        </message>
        <message>
            <source>There is no such part.</source>
            <translation>그런 공작물이 없습니다.</translation>
        </message>
        <message>
            <source>This LinuxCNC brings no such signal over HAL.</source>
            <translation>이 LinuxCNC는 HAL로 그런 신호를 주지 않습니다.</translation>
        </message>
        <message>
            <source>This LinuxCNC has no external offsets: set OFFSET_AV_RATIO in its ini.</source>
            <translation>이 LinuxCNC에는 외부 오프셋이 없습니다. ini에 OFFSET_AV_RATIO를 설정하십시오.</translation>
        </message>
        <message>
            <source>This computer is too busy, or real-time scheduling is not allowed.</source>
            <translation>컴퓨터가 너무 바쁘거나 실시간 스케줄링이 허용되지 않았습니다.</translation>
        </message>
        <message>
            <source>This control cannot do that.</source>
            <translation>이 제어기는 할 수 없습니다.</translation>
        </message>
        <message>
            <source>This control has no program for that process.</source>
            <translation>이 제어기에는 그 공정의 프로그램이 없습니다.</translation>
        </message>
        <message>
            <source>This lot is closed already, or there is none of that number.</source>
            <translation>이 로트는 이미 닫혔거나 그 번호가 없습니다.</translation>
        </message>
        <message>
            <source>This machine cannot host this loop.</source>
            <translation>이 기계에서는 이 루프를 쓸 수 없습니다.</translation>
        </message>
        <message>
            <source>This measurement was replaced meanwhile: look at the newest value first.</source>
            <translation>이 측정값은 그사이 바뀌었습니다. 먼저 최신 값을 보십시오.</translation>
        </message>
        <message>
            <source>This simulated machine does not have it.</source>
            <translation>이 시뮬레이션 기계에는 없습니다.</translation>
        </message>
        <message>
            <source>Time does not rise at sample %1; expected one row per sample, oldest first.</source>
            <translation>%1번 샘플에서 시간이 늘지 않습니다. 오래된 것부터 샘플마다 한 행이어야 합니다.</translation>
        </message>
        <message>
            <source>Too many entries are waiting to be stored; try again in a moment.</source>
            <translation>저장을 기다리는 입력이 너무 많습니다. 잠시 뒤 다시 해 보십시오.</translation>
        </message>
        <message>
            <source>What is left (%1 mm) is noise and scatter: further taps would not help.</source>
            <translation>남은 오차(%1 mm)는 잡음과 산포입니다. 더 탭을 내도 나아지지 않습니다.</translation>
        </message>
        <message>
            <source>Worse than before (%1 mm against %2 mm): back half way.</source>
            <translation>전보다 나빠졌습니다(%1 mm, 전에는 %2 mm). 절반만 되돌립니다.</translation>
        </message>
        <message>
            <source>Z moves %1 mm per revolution; that does not fit a pitch of %2 mm.</source>
            <translation>Z가 회전당 %1 mm 움직입니다. 피치 %2 mm와 맞지 않습니다.</translation>
        </message>
        <message>
            <source>%1 mm is far from the %2 mm expected here. Measure again, or confirm that it is so.</source>
            <translation>%1 mm는 여기서 예상한 %2 mm와 크게 다릅니다. 다시 측정하거나 맞는 값이라고 확인하십시오.</translation>
        </message>
        <message>
            <source>A bore is measured at 1 to %1 depths.</source>
            <translation>내경은 1~%1개 깊이에서 측정합니다.</translation>
        </message>
        <message>
            <source>A bore of %1 mm cannot be: without any bending it would be %2 mm. Measure again.</source>
            <translation>%1 mm 내경은 있을 수 없습니다. 휨이 전혀 없어도 %2 mm가 됩니다. 다시 측정하십시오.</translation>
        </message>
        <message>
            <source>A bore of part %1 was corrected; everything after it was computed again.</source>
            <translation>공작물 %1의 내경 값이 수정되어 이후 값을 모두 다시 계산했습니다.</translation>
        </message>
        <message>
            <source>A bore of part %1 was taken out; everything after it was computed again.</source>
            <translation>공작물 %1의 내경 값이 제외되어 이후 값을 모두 다시 계산했습니다.</translation>
        </message>
        <message>
            <source>A value is being stored; try again in a moment.</source>
            <translation>값을 저장하는 중입니다. 잠시 후 다시 시도하십시오.</translation>
        </message>
        <message>
            <source>Angle of the deflection</source>
            <translation>휨 각도</translation>
        </message>
        <message>
            <source>Depths must differ and lie inside the bore; %1 mm does not.</source>
            <translation>측정 깊이는 서로 다르고 내경 안에 있어야 합니다. %1 mm는 맞지 않습니다.</translation>
        </message>
        <message>
            <source>Feed exponent by experience</source>
            <translation>경험에 따른 이송 지수</translation>
        </message>
        <message>
            <source>Feed of the first part</source>
            <translation>첫 공작물의 이송</translation>
        </message>
        <message>
            <source>Highest feed</source>
            <translation>최대 이송</translation>
        </message>
        <message>
            <source>Largest diameter</source>
            <translation>최대 지름</translation>
        </message>
        <message>
            <source>Lot %1 was computed again from its measurements and differs from the stored state.</source>
            <translation>로트 %1을(를) 측정값으로 다시 계산한 결과가 저장된 상태와 다릅니다.</translation>
        </message>
        <message>
            <source>Lowest feed</source>
            <translation>최소 이송</translation>
        </message>
        <message>
            <source>Nothing is measured yet: the part is cut at the constant feed of %1 mm/rev.</source>
            <translation>아직 측정값이 없습니다. 공작물을 일정한 이송 %1 mm/rev로 가공합니다.</translation>
        </message>
        <message>
            <source>Overhang at the bottom</source>
            <translation>아래쪽 돌출 길이</translation>
        </message>
        <message>
            <source>Overhang at the top</source>
            <translation>위쪽 돌출 길이</translation>
        </message>
        <message>
            <source>Part %1 came out %2 µm larger than its target on average.</source>
            <translation>공작물 %1이(가) 평균적으로 목표보다 %2 µm 크게 나왔습니다.</translation>
        </message>
        <message>
            <source>Part %1 came out %2 µm smaller than its target on average.</source>
            <translation>공작물 %1이(가) 평균적으로 목표보다 %2 µm 작게 나왔습니다.</translation>
        </message>
        <message>
            <source>Part %1 came out on its target.</source>
            <translation>공작물 %1이(가) 목표대로 나왔습니다.</translation>
        </message>
        <message>
            <source>Smallest diameter</source>
            <translation>최소 지름</translation>
        </message>
        <message>
            <source>Spindle speed</source>
            <translation>주축 회전수</translation>
        </message>
        <message>
            <source>Standard deviation of the gauge</source>
            <translation>게이지의 표준편차</translation>
        </message>
        <message>
            <source>Target deflection</source>
            <translation>목표 휨</translation>
        </message>
        <message>
            <source>Target diameter</source>
            <translation>목표 지름</translation>
        </message>
        <message>
            <source>The bores differ from their prediction by more than chance: T² %1, limit %2.</source>
            <translation>내경이 예측과 우연 이상으로 다릅니다: T² %1, 한계 %2.</translation>
        </message>
        <message>
            <source>The lot asks for an estimator that this program does not have.</source>
            <translation>이 로트는 이 프로그램에 없는 추정기를 요구합니다.</translation>
        </message>
        <message>
            <source>The lowest feed must be below the highest one.</source>
            <translation>최소 이송은 최대 이송보다 작아야 합니다.</translation>
        </message>
        <message>
            <source>The overhang at the top must be below the one at the bottom.</source>
            <translation>위쪽 돌출 길이는 아래쪽보다 작아야 합니다.</translation>
        </message>
        <message>
            <source>The part type has no such depth.</source>
            <translation>이 품종에는 그런 측정 깊이가 없습니다.</translation>
        </message>
        <message>
            <source>The part type's parameters cannot be read; they need numbers under their keys.</source>
            <translation>품종의 파라미터를 읽을 수 없습니다. 각 항목에 숫자가 있어야 합니다.</translation>
        </message>
        <message>
            <source>The process changed with part %1: the law is learned anew from there.</source>
            <translation>공작물 %1부터 공정이 바뀌었습니다. 그 지점부터 법칙을 새로 학습합니다.</translation>
        </message>
        <message>
            <source>The target diameter must lie between the smallest and the largest one.</source>
            <translation>목표 지름은 최소와 최대 지름 사이에 있어야 합니다.</translation>
        </message>
        <message>
            <source>There is no measurement to undo.</source>
            <translation>취소할 측정값이 없습니다.</translation>
        </message>
        <message>
            <source>There is no such lot.</source>
            <translation>그런 로트가 없습니다.</translation>
        </message>
        <message>
            <source>This bore has a value already; correct that one instead.</source>
            <translation>이 내경에는 이미 값이 있습니다. 그 값을 수정하십시오.</translation>
        </message>
        <message>
            <source>This part has no finished bore to measure.</source>
            <translation>이 공작물에는 측정할 완성된 내경이 없습니다.</translation>
        </message>
        <message>
            <source>This value was replaced or taken out meanwhile; look at the newest one first.</source>
            <translation>이 값은 그사이 바뀌었거나 제외되었습니다. 먼저 최신 값을 확인하십시오.</translation>
        </message>
        <message>
            <source>Three measurements in a row lie more than 3σ off the target deflection.</source>
            <translation>연속한 세 측정값이 목표 휨에서 3σ 넘게 벗어났습니다.</translation>
        </message>
        <message>
            <source>drawing of the part</source>
            <translation>공작물 도면</translation>
        </message>
        <message>
            <source>set up with the machine</source>
            <translation>기계와 함께 설정</translation>
        </message>
        <message>
            <source>table 1 of Lee (1983)</source>
            <translation>Lee(1983)의 표 1</translation>
        </message>
        <message>
            <source>%1 has other temperature columns than %2; train with days of one machine.</source>
            <translation>%1의 온도 열이 %2와 다릅니다. 같은 기계의 데이터로 학습하십시오.</translation>
        </message>
        <message>
            <source>%1 is out of range; expected %2 to %3 degC.</source>
            <translation>%1이(가) 범위를 벗어났습니다. %2~%3 degC여야 합니다.</translation>
        </message>
        <message>
            <source>%1 min does not follow %2 min; expected rising time.</source>
            <translation>%1분이 %2분 다음에 올 수 없습니다. 시간은 증가해야 합니다.</translation>
        </message>
        <message>
            <source>A network of pairs needs at least 2 inputs; got %1.</source>
            <translation>쌍 네트워크에는 입력이 2개 이상 필요합니다. 현재 %1개입니다.</translation>
        </message>
        <message>
            <source>A training or check set has only %1 rows; expected at least %2.</source>
            <translation>학습 또는 검사 데이터가 %1행뿐입니다. %2행 이상이어야 합니다.</translation>
        </message>
        <message>
            <source>Network width %1 is out of range; expected 1 to %2.</source>
            <translation>네트워크 폭 %1이(가) 범위를 벗어났습니다. 1~%2여야 합니다.</translation>
        </message>
        <message>
            <source>No training day was given.</source>
            <translation>학습 데이터가 지정되지 않았습니다.</translation>
        </message>
        <message>
            <source>The network reads %1 sensors; at most %2 are supported.</source>
            <translation>네트워크가 센서 %1개를 사용합니다. 최대 %2개까지 지원합니다.</translation>
        </message>
        <message>
            <source>Training was cancelled.</source>
            <translation>학습이 취소되었습니다.</translation>
        </message>
        <message>
            <source>baseline of %1 looks like degrees Fahrenheit; expected degC.</source>
            <translation>기준값 %1은(는) 화씨로 보입니다. degC여야 합니다.</translation>
        </message>
        <message>
            <source>constant at %1 in every row; expected a temperature that moves. Leave the column out.</source>
            <translation>모든 행에서 %1로 일정합니다. 변하는 온도여야 합니다. 이 열을 제외하십시오.</translation>
        </message>
        <message>
            <source>fewer than two temperature columns.</source>
            <translation>온도 열이 두 개보다 적습니다.</translation>
        </message>
        <message>
            <source>gap of %1 min; expected an even step of %2 min without gaps.</source>
            <translation>%1분의 빈틈이 있습니다. 빈틈 없이 %2분 간격이어야 합니다.</translation>
        </message>
        <message>
            <source>largest drift is %1 while the machine warms by %2 K; expected um, not mm.</source>
            <translation>기계가 %2 K 데워지는 동안 최대 변위가 %1입니다. mm가 아니라 um이어야 합니다.</translation>
        </message>
        <message>
            <source>no reading; training data must be without gaps.</source>
            <translation>읽은 값이 없습니다. 학습 데이터에는 빈틈이 없어야 합니다.</translation>
        </message>
        <message>
            <source>no row at or after time 0.</source>
            <translation>시각 0 이후의 행이 없습니다.</translation>
        </message>
        <message>
            <source>no row before time 0; expected at least one baseline row with t_min &lt; 0.</source>
            <translation>시각 0 이전의 행이 없습니다. t_min &lt; 0인 기준 행이 하나 이상 있어야 합니다.</translation>
        </message>
        <message>
            <source>no usable drift; expected a number from -1000 to 1000 um.</source>
            <translation>쓸 수 있는 변위가 없습니다. -1000~1000 um의 숫자여야 합니다.</translation>
        </message>
        <message>
            <source>only %1 rows from time 0; training needs at least %2.</source>
            <translation>시각 0 이후 %1행뿐입니다. 학습에는 %2행 이상이 필요합니다.</translation>
        </message>
        <message>
            <source>too short; expected baseline rows and at least one row from time 0.</source>
            <translation>너무 짧습니다. 기준 행과 시각 0 이후의 행이 하나 이상 있어야 합니다.</translation>
        </message>
        <message>
            <source>%1 times the force at the start of the cut.</source>
            <translation>절삭 시작 때 힘의 %1배입니다.</translation>
        </message>
        <message>
            <source>A vibration repeats with every revolution, so the force does not change with it.</source>
            <translation>진동이 회전마다 같은 위상으로 되풀이되어 힘에 나타나지 않습니다.</translation>
        </message>
        <message>
            <source>At most 8 known tones.</source>
            <translation>알려진 진동 주파수는 8개까지입니다.</translation>
        </message>
        <message>
            <source>Check depth of cut and amplifier range before the next part.</source>
            <translation>다음 공작물 전에 절삭 깊이와 앰프 범위를 점검하십시오.</translation>
        </message>
        <message>
            <source>Check depth of cut and touch-off before the next part.</source>
            <translation>다음 공작물 전에 절삭 깊이와 터치오프를 점검하십시오.</translation>
        </message>
        <message>
            <source>Choose the spindle speed that the page suggests.</source>
            <translation>화면이 제안하는 주축 회전수를 고르십시오.</translation>
        </message>
        <message>
            <source>Find the source of the vibration; see the spectrum's tones.</source>
            <translation>진동의 원인을 찾으십시오. 스펙트럼의 주파수를 보십시오.</translation>
        </message>
        <message>
            <source>Force feedback needs a cycle of 0.2 ms; this machine has %1 ms: no trim.</source>
            <translation>힘 피드백에는 0.2 ms 주기가 필요한데 이 기계는 %1 ms입니다. 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>Force sensor at the end of its range</source>
            <translation>힘 센서가 측정 범위 끝에 있음</translation>
        </message>
        <message>
            <source>Force sensor at the end of its range: no trim in this part.</source>
            <translation>힘 센서가 측정 범위 끝에 있어 이 공작물은 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>Force signal lost</source>
            <translation>힘 신호 끊김</translation>
        </message>
        <message>
            <source>Force signal lost: the trim is zero.</source>
            <translation>힘 신호가 끊겨 보정을 0으로 했습니다.</translation>
        </message>
        <message>
            <source>Listening to the disturbance: no trim yet.</source>
            <translation>외란을 듣는 중이며 아직 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>No turning setup is loaded: enter the cut first.</source>
            <translation>선삭 설정이 없습니다. 먼저 절삭 조건을 입력하십시오.</translation>
        </message>
        <message>
            <source>None, unless it comes back with every part: then check the sensor's insulation.</source>
            <translation>없습니다. 공작물마다 되풀이되면 센서의 절연을 점검하십시오.</translation>
        </message>
        <message>
            <source>Out of the cut: the sensor's zero is taken.</source>
            <translation>절삭 밖: 센서의 영점을 잡습니다.</translation>
        </message>
        <message>
            <source>Part of the disturbance stays on the surface.</source>
            <translation>외란의 일부가 표면에 남습니다.</translation>
        </message>
        <message>
            <source>Ready: force feedback begins at the touch of the next part.</source>
            <translation>준비됨: 다음 공작물에 닿으면 힘 피드백을 시작합니다.</translation>
        </message>
        <message>
            <source>The cut is deeper or the amplifier more sensitive than the sensor's range allows.</source>
            <translation>센서 범위에 비해 절삭이 깊거나 앰프 감도가 높습니다.</translation>
        </message>
        <message>
            <source>The cutting force has jumped: the tool may be chipped</source>
            <translation>절삭력이 갑자기 변함: 공구 이빠짐 의심</translation>
        </message>
        <message>
            <source>The cutting force has jumped: the trim is zero, look at the tool.</source>
            <translation>절삭력이 갑자기 변했습니다. 보정을 0으로 했으니 공구를 살피십시오.</translation>
        </message>
        <message>
            <source>The disturbance is larger than the trim may correct.</source>
            <translation>외란이 허용된 보정량보다 큽니다.</translation>
        </message>
        <message>
            <source>The face must end beyond its start.</source>
            <translation>단면의 끝은 시작보다 뒤여야 합니다.</translation>
        </message>
        <message>
            <source>The force cannot see a tone at this spindle speed</source>
            <translation>이 주축 회전수에서는 힘으로 볼 수 없는 주파수가 있음</translation>
        </message>
        <message>
            <source>The force sensor has drifted</source>
            <translation>힘 센서 영점이 이동함</translation>
        </message>
        <message>
            <source>The force sensor is unplugged, its values are old, not numbers, or do not change any more.</source>
            <translation>힘 센서가 빠졌거나, 값이 오래되었거나, 숫자가 아니거나, 더 이상 변하지 않습니다.</translation>
        </message>
        <message>
            <source>The mean of the trim is not zero: the loop would change the depth of cut.</source>
            <translation>보정의 평균이 0이 아닙니다. 루프가 절삭 깊이를 바꾸게 됩니다.</translation>
        </message>
        <message>
            <source>The piezo sensor's zero out of the cut is not where it was.</source>
            <translation>절삭 밖에서 압전 센서의 영점이 전과 다릅니다.</translation>
        </message>
        <message>
            <source>The same depth takes clearly more force than at the start of this cut.</source>
            <translation>같은 깊이인데 절삭 시작 때보다 힘이 뚜렷이 큽니다.</translation>
        </message>
        <message>
            <source>The tone is held only for about a minute; then it comes back on the surface.</source>
            <translation>그 주파수는 1분쯤만 억제되고 그 뒤 표면에 다시 나타납니다.</translation>
        </message>
        <message>
            <source>The tool has touched: first revolution.</source>
            <translation>공구가 닿았습니다: 첫 회전.</translation>
        </message>
        <message>
            <source>The trim cancels %1 tones of the disturbance.</source>
            <translation>보정이 외란의 주파수 %1개를 상쇄합니다.</translation>
        </message>
        <message>
            <source>The trim has gone to zero for the rest of this part.</source>
            <translation>이 공작물의 나머지는 보정을 0으로 합니다.</translation>
        </message>
        <message>
            <source>The trim has gone to zero for the rest of this part; the depth is the programmed one.</source>
            <translation>이 공작물의 나머지는 보정을 0으로 하며 깊이는 프로그램 값입니다.</translation>
        </message>
        <message>
            <source>The trim leans to one side</source>
            <translation>보정이 한쪽으로 치우침</translation>
        </message>
        <message>
            <source>The trim leans to one side: no trim in this part.</source>
            <translation>보정이 한쪽으로 치우쳐 이 공작물은 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>The trim sits at its limit</source>
            <translation>보정이 한계에 있음</translation>
        </message>
        <message>
            <source>The turning loop does not know this command.</source>
            <translation>선삭 루프가 모르는 명령입니다.</translation>
        </message>
        <message>
            <source>The turning program needs feed and depth above zero, 150 to 30000 rev/min, and an end beyond its start.</source>
            <translation>선삭 프로그램에는 0보다 큰 이송과 깊이, 150~30000 rev/min, 시작보다 뒤인 끝이 필요합니다.</translation>
        </message>
        <message>
            <source>The zero has moved by %1 N.</source>
            <translation>영점이 %1 N 이동했습니다.</translation>
        </message>
        <message>
            <source>The zero was taken again; the force shown is right.</source>
            <translation>영점을 다시 잡았습니다. 표시된 힘은 맞습니다.</translation>
        </message>
        <message>
            <source>%1 N at %2 mm; the limit is %3 N.</source>
            <translation>%2 mm에서 %1 N. 한계는 %3 N입니다.</translation>
        </message>
        <message>
            <source>%1 revolutions in, at %2 mm.</source>
            <translation>%1회전 들어간 위치, %2 mm.</translation>
        </message>
        <message>
            <source>%1 µm at %2 revolutions; the limit is %3 µm.</source>
            <translation>%2회전에서 %1 µm. 한계는 %3 µm입니다.</translation>
        </message>
        <message>
            <source>A gain is not a number above zero; the last ones stay.</source>
            <translation>게인이 0보다 큰 숫자가 아닙니다. 이전 값을 유지합니다.</translation>
        </message>
        <message>
            <source>A part is being cut: law and reference can be changed now, the rest after it.</source>
            <translation>가공 중입니다. 법칙과 기준값은 지금, 나머지는 가공 후에 바꿀 수 있습니다.</translation>
        </message>
        <message>
            <source>A tap is under way.</source>
            <translation>탭 가공 중입니다.</translation>
        </message>
        <message>
            <source>A tap is under way: the job stays.</source>
            <translation>탭 가공 중이므로 작업을 바꾸지 않습니다.</translation>
        </message>
        <message>
            <source>A tap stands in the hole: turn it out first.</source>
            <translation>탭이 구멍 안에 있습니다. 먼저 돌려 빼십시오.</translation>
        </message>
        <message>
            <source>A tuning is under way: accept it or roll it back first.</source>
            <translation>튜닝 중입니다. 먼저 수락하거나 되돌리십시오.</translation>
        </message>
        <message>
            <source>Across-wall stiffness</source>
            <translation>벽 직각 방향 강성</translation>
        </message>
        <message>
            <source>Air tap: Z and spindle move, no work.</source>
            <translation>에어 탭: Z와 주축만 움직이고 가공하지 않습니다.</translation>
        </message>
        <message>
            <source>An emergency stop or an abort at the control stopped the tap before it was out.</source>
            <translation>비상 정지나 제어기의 중단으로 탭이 빠져나오기 전에 멈췄습니다.</translation>
        </message>
        <message>
            <source>Change the reference or the feed limits, or accept the deviation.</source>
            <translation>기준값이나 이송 한계를 바꾸거나 편차를 받아들이십시오.</translation>
        </message>
        <message>
            <source>Change the tool and press New tool on the Milling page.</source>
            <translation>공구를 교체하고 밀링 화면에서 새 공구를 누르십시오.</translation>
        </message>
        <message>
            <source>Check tap and lubrication, then tune again.</source>
            <translation>탭과 윤활을 확인한 뒤 다시 튜닝하십시오.</translation>
        </message>
        <message>
            <source>Check that the control allows setting gains, then try again.</source>
            <translation>제어기가 게인 설정을 허용하는지 확인한 뒤 다시 시도하십시오.</translation>
        </message>
        <message>
            <source>Check the axis' position signal. Control goes on by itself when it is back.</source>
            <translation>축 위치 신호를 확인하십시오. 신호가 돌아오면 제어가 저절로 계속됩니다.</translation>
        </message>
        <message>
            <source>Check the encoders. Gauge the thread.</source>
            <translation>엔코더를 확인하고 나사를 게이지로 검사하십시오.</translation>
        </message>
        <message>
            <source>Check the force sensor, its plug and its amplifier. Control goes on by itself when the signal is back.</source>
            <translation>힘 센서와 커넥터, 증폭기를 확인하십시오. 신호가 돌아오면 제어가 저절로 계속됩니다.</translation>
        </message>
        <message>
            <source>Compare pitch entered, program and tool before the next tap.</source>
            <translation>다음 탭 전에 입력한 피치와 프로그램, 공구를 비교하십시오.</translation>
        </message>
        <message>
            <source>Control would have held the feed: see the alarm.</source>
            <translation>제어 중이었다면 이송을 멈췄을 것입니다. 알람을 확인하십시오.</translation>
        </message>
        <message>
            <source>Cutting force above its limit</source>
            <translation>절삭력이 한계를 넘음</translation>
        </message>
        <message>
            <source>Cutting force unknown</source>
            <translation>절삭력을 알 수 없음</translation>
        </message>
        <message>
            <source>Cutting force unknown: no faster than planned.</source>
            <translation>절삭력을 알 수 없어 계획보다 빠르게 가지 않습니다.</translation>
        </message>
        <message>
            <source>Entry feed</source>
            <translation>진입 이송</translation>
        </message>
        <message>
            <source>Feed really made is unknown</source>
            <translation>실제 이송을 알 수 없음</translation>
        </message>
        <message>
            <source>Feed really made is unknown: no faster than planned.</source>
            <translation>실제 이송을 알 수 없어 계획보다 빠르게 가지 않습니다.</translation>
        </message>
        <message>
            <source>Flutes</source>
            <translation>날 수</translation>
        </message>
        <message>
            <source>Force angle</source>
            <translation>힘 각도</translation>
        </message>
        <message>
            <source>Force limit</source>
            <translation>힘 한계</translation>
        </message>
        <message>
            <source>Gains are being set; nothing turns.</source>
            <translation>게인을 설정하는 중이며 아무것도 회전하지 않습니다.</translation>
        </message>
        <message>
            <source>Gains change only between taps.</source>
            <translation>게인은 탭과 탭 사이에만 바뀝니다.</translation>
        </message>
        <message>
            <source>Gauge the thread. Look at the record before the next trial.</source>
            <translation>나사를 게이지로 검사하고 다음 시험 전에 기록을 확인하십시오.</translation>
        </message>
        <message>
            <source>In air: entry feed until the tool meets the work.</source>
            <translation>공중: 공구가 공작물에 닿을 때까지 진입 이송으로 갑니다.</translation>
        </message>
        <message>
            <source>Integral gain</source>
            <translation>적분 게인</translation>
        </message>
        <message>
            <source>Material exponent</source>
            <translation>재료 지수</translation>
        </message>
        <message>
            <source>No blank profile is loaded: enter or import one.</source>
            <translation>소재 형상이 없습니다. 입력하거나 불러오십시오.</translation>
        </message>
        <message>
            <source>No cut to learn from yet: mill one part, advising or controlled.</source>
            <translation>아직 배울 절삭이 없습니다. 추천 또는 제어로 공작물 하나를 가공하십시오.</translation>
        </message>
        <message>
            <source>No milling setup is loaded.</source>
            <translation>밀링 설정이 없습니다.</translation>
        </message>
        <message>
            <source>No tap is made.</source>
            <translation>탭을 가공하지 않습니다.</translation>
        </message>
        <message>
            <source>No tap stands in a hole.</source>
            <translation>구멍 안에 있는 탭이 없습니다.</translation>
        </message>
        <message>
            <source>No tapping job is loaded.</source>
            <translation>태핑 작업이 없습니다.</translation>
        </message>
        <message>
            <source>Path end</source>
            <translation>경로 끝</translation>
        </message>
        <message>
            <source>Path start</source>
            <translation>경로 시작</translation>
        </message>
        <message>
            <source>Planned feed</source>
            <translation>계획 이송</translation>
        </message>
        <message>
            <source>Proportional gain</source>
            <translation>비례 게인</translation>
        </message>
        <message>
            <source>Ready: the first tap of the job is an air tap.</source>
            <translation>준비됨: 작업의 첫 탭은 에어 탭입니다.</translation>
        </message>
        <message>
            <source>Ready: the next cut holds the reference force.</source>
            <translation>준비됨: 다음 절삭은 기준 힘을 유지합니다.</translation>
        </message>
        <message>
            <source>Ready: the next cut is made at its planned feed.</source>
            <translation>준비됨: 다음 절삭은 계획 이송으로 합니다.</translation>
        </message>
        <message>
            <source>Ready: the next tap uses the gains shown.</source>
            <translation>준비됨: 다음 탭은 표시된 게인을 사용합니다.</translation>
        </message>
        <message>
            <source>Ready: the next tap uses the machine's own gains.</source>
            <translation>준비됨: 다음 탭은 기계 자체의 게인을 사용합니다.</translation>
        </message>
        <message>
            <source>Reference force</source>
            <translation>기준 힘</translation>
        </message>
        <message>
            <source>Reference force out of reach</source>
            <translation>기준 힘에 도달할 수 없음</translation>
        </message>
        <message>
            <source>Repeat the tap.</source>
            <translation>탭을 다시 가공하십시오.</translation>
        </message>
        <message>
            <source>Spindle angle or Z position were missing for more than 20 ms during a tap.</source>
            <translation>탭 가공 중 주축 각도나 Z 위치가 20 ms 넘게 없었습니다.</translation>
        </message>
        <message>
            <source>Spindle stopped in the cut</source>
            <translation>절삭 중 주축 정지</translation>
        </message>
        <message>
            <source>Switch the tapping loop to control to turn the tap out.</source>
            <translation>탭을 돌려 빼려면 태핑 루프를 제어로 바꾸십시오.</translation>
        </message>
        <message>
            <source>Tap not counted</source>
            <translation>탭을 세지 않음</translation>
        </message>
        <message>
            <source>Tapping and recording.</source>
            <translation>탭 가공과 기록 중입니다.</translation>
        </message>
        <message>
            <source>Tapping error beyond its limit</source>
            <translation>태핑 오차가 한계를 넘음</translation>
        </message>
        <message>
            <source>Tapping error has grown</source>
            <translation>태핑 오차가 커짐</translation>
        </message>
        <message>
            <source>Tapping signal lost</source>
            <translation>태핑 신호 끊김</translation>
        </message>
        <message>
            <source>The air tap shows another pitch than the one entered.</source>
            <translation>에어 탭의 피치가 입력한 피치와 다릅니다.</translation>
        </message>
        <message>
            <source>The cutting force collapsed within half a revolution while the tool was in the work.</source>
            <translation>공구가 공작물 안에 있는데 반 회전 안에 절삭력이 사라졌습니다.</translation>
        </message>
        <message>
            <source>The cutting stiffness has risen by %1 % since the tool was new.</source>
            <translation>새 공구 때보다 절삭 강성이 %1 % 높아졌습니다.</translation>
        </message>
        <message>
            <source>The database cannot be opened for the export.</source>
            <translation>내보내기를 위해 데이터베이스를 열 수 없습니다.</translation>
        </message>
        <message>
            <source>The depth of cut is larger than expected, the tool is blunt, or the material is harder.</source>
            <translation>절삭 깊이가 예상보다 크거나 공구가 무디거나 재료가 더 단단합니다.</translation>
        </message>
        <message>
            <source>The drive did not take the gains</source>
            <translation>드라이브가 게인을 받지 않음</translation>
        </message>
        <message>
            <source>The engine takes no commands at the moment; try again.</source>
            <translation>지금은 엔진이 명령을 받지 않습니다. 다시 시도하십시오.</translation>
        </message>
        <message>
            <source>The export could not be written completely.</source>
            <translation>내보내기를 끝까지 쓰지 못했습니다.</translation>
        </message>
        <message>
            <source>The feed holds the reference force.</source>
            <translation>이송으로 기준 힘을 유지합니다.</translation>
        </message>
        <message>
            <source>The feed is held: see the alarm, then release the feed here.</source>
            <translation>이송이 멈춰 있습니다. 알람을 확인한 뒤 여기서 이송을 해제하십시오.</translation>
        </message>
        <message>
            <source>The feed is not controlled: it stays, or falls to the planned feed if it was faster.</source>
            <translation>이송을 제어하지 않습니다. 그대로 두거나, 더 빨랐다면 계획 이송으로 낮춥니다.</translation>
        </message>
        <message>
            <source>The feed signal of the axis is missing, old or not a number.</source>
            <translation>축의 이송 신호가 없거나 오래되었거나 숫자가 아닙니다.</translation>
        </message>
        <message>
            <source>The feed sits at its limit: the blank is too thin or too thick for the reference.</source>
            <translation>이송이 한계에 있습니다. 소재가 기준 힘에 비해 너무 얇거나 두껍습니다.</translation>
        </message>
        <message>
            <source>The feed stands; control goes on with it.</source>
            <translation>이송이 멈춰 있으며, 다시 움직이면 제어가 계속됩니다.</translation>
        </message>
        <message>
            <source>The file cannot be written there. Choose another folder.</source>
            <translation>그곳에 파일을 쓸 수 없습니다. 다른 폴더를 고르십시오.</translation>
        </message>
        <message>
            <source>The file could not be finished: the disk is full or was taken away.</source>
            <translation>파일을 끝내지 못했습니다. 디스크가 가득 찼거나 제거되었습니다.</translation>
        </message>
        <message>
            <source>The force differs from the reference, so the wall is not as flat as it could be.</source>
            <translation>힘이 기준과 달라 벽이 가능한 만큼 평탄하지 않습니다.</translation>
        </message>
        <message>
            <source>The force sensor is not plugged in.</source>
            <translation>힘 센서가 연결되지 않았습니다.</translation>
        </message>
        <message>
            <source>The force signal is at the end of its range.</source>
            <translation>힘 신호가 측정 범위 끝에 있습니다.</translation>
        </message>
        <message>
            <source>The force signal is missing, old, stuck, at the end of its range or not a number.</source>
            <translation>힘 신호가 없거나 오래되었거나 고정되었거나 범위 끝에 있거나 숫자가 아닙니다.</translation>
        </message>
        <message>
            <source>The force signal is old.</source>
            <translation>힘 신호가 오래되었습니다.</translation>
        </message>
        <message>
            <source>The force signal is stuck or not a number.</source>
            <translation>힘 신호가 고정되었거나 숫자가 아닙니다.</translation>
        </message>
        <message>
            <source>The gains sent to the drive were refused or did not read back within a second.</source>
            <translation>드라이브에 보낸 게인이 거부되었거나 1초 안에 되읽히지 않았습니다.</translation>
        </message>
        <message>
            <source>The milling loop does not know this command.</source>
            <translation>밀링 루프가 모르는 명령입니다.</translation>
        </message>
        <message>
            <source>The milling program needs feed and speed above zero and an end beyond its start.</source>
            <translation>밀링 프로그램에는 0보다 큰 이송과 회전수, 시작보다 뒤에 있는 끝이 필요합니다.</translation>
        </message>
        <message>
            <source>The milling setup is not complete.</source>
            <translation>밀링 설정이 완전하지 않습니다.</translation>
        </message>
        <message>
            <source>The planned feed is kept.</source>
            <translation>계획 이송을 유지합니다.</translation>
        </message>
        <message>
            <source>The reference force needs a feed outside %1 to %2 mm/s.</source>
            <translation>기준 힘을 내려면 %1~%2 mm/s를 벗어난 이송이 필요합니다.</translation>
        </message>
        <message>
            <source>The same cut needs a larger force than with the new tool.</source>
            <translation>같은 절삭에 새 공구 때보다 큰 힘이 듭니다.</translation>
        </message>
        <message>
            <source>The spindle turns slower than half its programmed speed, or its speed is unknown.</source>
            <translation>주축이 프로그램 속도의 절반보다 느리거나 속도를 알 수 없습니다.</translation>
        </message>
        <message>
            <source>The sum of errors of the last taps lies above that of the first taps after the tuning.</source>
            <translation>최근 탭의 오차 합이 튜닝 직후 탭보다 큽니다.</translation>
        </message>
        <message>
            <source>The tap is turned out in sync.</source>
            <translation>탭을 동기로 돌려 빼는 중입니다.</translation>
        </message>
        <message>
            <source>The tap stands %1 revolutions in the hole: turn it out in sync.</source>
            <translation>탭이 구멍 안 %1회전 위치에 있습니다. 동기로 돌려 빼십시오.</translation>
        </message>
        <message>
            <source>The tap stands in the hole</source>
            <translation>탭이 구멍 안에 있음</translation>
        </message>
        <message>
            <source>The tap stands in the hole.</source>
            <translation>탭이 구멍 안에 있습니다.</translation>
        </message>
        <message>
            <source>The tap stands in the hole: turn it out in sync, then tune again.</source>
            <translation>탭이 구멍 안에 있습니다. 동기로 돌려 뺀 뒤 다시 튜닝하십시오.</translation>
        </message>
        <message>
            <source>The tap was aborted: the accepted gains are back in force.</source>
            <translation>탭이 중단되어 수락된 게인으로 되돌렸습니다.</translation>
        </message>
        <message>
            <source>The tapping job has a value outside its range.</source>
            <translation>태핑 작업에 범위를 벗어난 값이 있습니다.</translation>
        </message>
        <message>
            <source>The tapping loop does not know this command.</source>
            <translation>태핑 루프가 모르는 명령입니다.</translation>
        </message>
        <message>
            <source>The tapping program needs pitch, revolutions and speed above zero.</source>
            <translation>태핑 프로그램에는 0보다 큰 피치와 회전 수, 속도가 필요합니다.</translation>
        </message>
        <message>
            <source>The tuner does not learn from it.</source>
            <translation>튜너가 이 탭에서 배우지 않습니다.</translation>
        </message>
        <message>
            <source>The wall stays flat, but the feed falls with the wear and the tool may break.</source>
            <translation>벽은 평탄하지만 마모로 이송이 느려지고 공구가 부러질 수 있습니다.</translation>
        </message>
        <message>
            <source>This machine has no force sensor.</source>
            <translation>이 기계에는 힘 센서가 없습니다.</translation>
        </message>
        <message>
            <source>This recipe revision cannot be read: it is no list of parameters.</source>
            <translation>이 레시피 개정을 읽을 수 없습니다. 파라미터 목록이 아닙니다.</translation>
        </message>
        <message>
            <source>This thread is not in the table.</source>
            <translation>이 나사는 표에 없습니다.</translation>
        </message>
        <message>
            <source>Threads are still made; their tolerance is used up slowly.</source>
            <translation>나사는 계속 가공되지만 공차가 서서히 소진됩니다.</translation>
        </message>
        <message>
            <source>Tool broken?</source>
            <translation>공구 파손?</translation>
        </message>
        <message>
            <source>Tool radius</source>
            <translation>공구 반지름</translation>
        </message>
        <message>
            <source>Tool wear above its threshold</source>
            <translation>공구 마모가 기준을 넘음</translation>
        </message>
        <message>
            <source>Wear threshold</source>
            <translation>마모 기준</translation>
        </message>
        <message>
            <source>Wrong pitch</source>
            <translation>피치 오류</translation>
        </message>
        <message>
            <source>Z and spindle were further apart than the abort limit during a tap.</source>
            <translation>탭 가공 중 Z와 주축의 차이가 중단 한계를 넘었습니다.</translation>
        </message>
        <message>
            <source>Z moves %1 mm per revolution, the pitch entered is %2 mm.</source>
            <translation>Z가 회전당 %1 mm 움직이지만 입력한 피치는 %2 mm입니다.</translation>
        </message>
        <message>
            <source>Z moves by another distance per revolution than the pitch entered.</source>
            <translation>Z가 회전당 입력한 피치와 다른 거리를 움직입니다.</translation>
        </message>
        <message>
            <source>Cutting stiffness ln(C b)</source>
            <translation>절삭 강성 ln(C b)</translation>
        </message>
        <message>
            <source>Largest trim</source>
            <translation>최대 보정</translation>
        </message>
        <message>
            <source>Mean force</source>
            <translation>평균 힘</translation>
        </message>
        <message>
            <source>On the built-in diamond lathe: start the console with --machine diamond-lathe.</source>
            <translation>내장 다이아몬드 선반에 있습니다: 콘솔을 --machine diamond-lathe 로 시작하십시오.</translation>
        </message>
        <message>
            <source>On the built-in machining centre: start the console with --machine simulator.</source>
            <translation>내장 머시닝 센터에 있습니다: 콘솔을 --machine simulator 로 시작하십시오.</translation>
        </message>
        <message>
            <source>Peak at</source>
            <translation>최대 힘 위치</translation>
        </message>
        <message>
            <source>Peak force</source>
            <translation>최대 힘</translation>
        </message>
        <message>
            <source>Surface P-V</source>
            <translation>표면 P-V</translation>
        </message>
        <message>
            <source>Surface RMS</source>
            <translation>표면 RMS</translation>
        </message>
        <message>
            <source>Time at planned feed</source>
            <translation>계획 이송 시간</translation>
        </message>
        <message>
            <source>Time cut</source>
            <translation>절삭 시간</translation>
        </message>
        <message>
            <source>Time under control</source>
            <translation>제어 시 시간</translation>
        </message>
        <message>
            <source>Waviness</source>
            <translation>파상도</translation>
        </message>
        <message>
            <source>Without the loop</source>
            <translation>루프 없을 때</translation>
        </message>
        <message>
            <source>A lot has at most %1 parts.</source>
            <translation>로트의 공작물은 최대 %1개입니다.</translation>
        </message>
        <message>
            <source>A lot needs a name or number.</source>
            <translation>로트에는 이름이나 번호가 필요합니다.</translation>
        </message>
        <message>
            <source>A part of this lot is being bored; change the lot when it is finished.</source>
            <translation>이 로트의 공작물을 보링하는 중입니다. 끝난 뒤에 로트를 바꾸십시오.</translation>
        </message>
        <message>
            <source>A part type needs a name.</source>
            <translation>품종에는 이름이 필요합니다.</translation>
        </message>
        <message>
            <source>A recipe needs %1 numbers.</source>
            <translation>레시피에는 숫자 %1개가 필요합니다.</translation>
        </message>
        <message>
            <source>Overhang where the bore is measured</source>
            <translation>내경을 측정하는 돌출 길이</translation>
        </message>
        <message>
            <source>Parts in the lot</source>
            <translation>로트의 공작물 수</translation>
        </message>
        <message>
            <source>There is a lot of this name for the part type already; give another name.</source>
            <translation>이 품종에 같은 이름의 로트가 이미 있습니다. 다른 이름을 쓰십시오.</translation>
        </message>
        <message>
            <source>There is a part type of this name already; give another name.</source>
            <translation>같은 이름의 품종이 이미 있습니다. 다른 이름을 쓰십시오.</translation>
        </message>
        <message>
            <source>There is no such part type.</source>
            <translation>그런 품종이 없습니다.</translation>
        </message>
        <message>
            <source>This change needs a reason.</source>
            <translation>이 변경에는 사유가 필요합니다.</translation>
        </message>
        <message>
            <source>work order</source>
            <translation>작업 지시서</translation>
        </message>
        <message>
            <source>%1 rows; a blank profile needs from 2 to %2, the last one ends the blank.</source>
            <translation>%1행입니다. 소재 형상은 2행에서 %2행까지이며 마지막 행이 소재의 끝입니다.</translation>
        </message>
        <message>
            <source>Blank ends at</source>
            <translation>소재 끝 위치</translation>
        </message>
        <message>
            <source>Height of the step</source>
            <translation>단 높이</translation>
        </message>
        <message>
            <source>Its 95 % half width</source>
            <translation>그 95 % 반폭</translation>
        </message>
        <message>
            <source>Line %1, column %2: “%3” is not a number.</source>
            <translation>%1행 %2열: “%3”은(는) 숫자가 아닙니다.</translation>
        </message>
        <message>
            <source>Line %1, column height_mm: %2 mm must be from 0 to %3 mm.</source>
            <translation>%1행 height_mm열: %2 mm은(는) 0에서 %3 mm까지여야 합니다.</translation>
        </message>
        <message>
            <source>Line %1, column x_mm: %2 mm must lie beyond the step before, %3 mm.</source>
            <translation>%1행 x_mm열: %2 mm은(는) 앞 단의 위치 %3 mm보다 뒤여야 합니다.</translation>
        </message>
        <message>
            <source>Line %1: %2 columns, expected are 2: x_mm,height_mm.</source>
            <translation>%1행: %2열입니다. x_mm,height_mm 2열이어야 합니다.</translation>
        </message>
        <message>
            <source>Line %1: the first line must name the columns x_mm,height_mm.</source>
            <translation>%1행: 첫 행에는 열 이름 x_mm,height_mm이 있어야 합니다.</translation>
        </message>
        <message>
            <source>Oh and Jeong (1987)</source>
            <translation>Oh, Jeong(1987)</translation>
        </message>
        <message>
            <source>Saved</source>
            <translation>절약</translation>
        </message>
        <message>
            <source>Sign on first: a change needs a name.</source>
            <translation>먼저 로그인하십시오. 변경에는 이름이 필요합니다.</translation>
        </message>
        <message>
            <source>Step begins at</source>
            <translation>단 시작 위치</translation>
        </message>
        <message>
            <source>Stops by the loop</source>
            <translation>루프에 의한 정지</translation>
        </message>
        <message>
            <source>The feed is not controlled: it stays, or falls to the planned feed if it was faster. Overload and breakage are not noticed.</source>
            <translation>이송을 제어하지 않습니다. 그대로 두거나, 더 빨랐으면 계획 이송으로 낮춥니다. 과부하와 파손을 알아차리지 못합니다.</translation>
        </message>
        <message>
            <source>The file cannot be read. Check its name and folder.</source>
            <translation>파일을 읽을 수 없습니다. 이름과 폴더를 확인하십시오.</translation>
        </message>
        <message>
            <source>The file is too large for a blank profile.</source>
            <translation>소재 형상 파일로는 너무 큽니다.</translation>
        </message>
        <message>
            <source>The stored state of the tool cannot be used.</source>
            <translation>저장된 공구 상태를 쓸 수 없습니다.</translation>
        </message>
        <message>
            <source>Time above reference</source>
            <translation>기준 초과 시간</translation>
        </message>
        <message>
            <source>What was stored for milling cannot be read.</source>
            <translation>밀링에 저장된 내용을 읽을 수 없습니다.</translation>
        </message>
        <message>
            <source>calibrated on the published cuts</source>
            <translation>발표된 절삭으로 교정</translation>
        </message>
        <message>
            <source>part program</source>
            <translation>가공 프로그램</translation>
        </message>
        <message>
            <source>Depth of cut</source>
            <translation>절삭 깊이</translation>
        </message>
        <message>
            <source>Face from</source>
            <translation>면의 시작</translation>
        </message>
        <message>
            <source>Face to</source>
            <translation>면의 끝</translation>
        </message>
        <message>
            <source>Feed per revolution</source>
            <translation>회전당 이송</translation>
        </message>
        <message>
            <source>Jeong &amp; Kim: the cut in copper</source>
            <translation>Jeong &amp; Kim: 구리 절삭</translation>
        </message>
        <message>
            <source>Known tone</source>
            <translation>알려진 진동 주파수</translation>
        </message>
        <message>
            <source>Open: the disturbance is watched, the tool is not trimmed.</source>
            <translation>개루프: 외란을 지켜보기만 하고 공구를 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>P-V, second half</source>
            <translation>P-V, 후반</translation>
        </message>
        <message>
            <source>RMS, second half</source>
            <translation>RMS, 후반</translation>
        </message>
        <message>
            <source>The mean force has fallen: no trim in this part.</source>
            <translation>평균 힘이 떨어져 이 공작물은 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>The mean of the trim is %1 um.</source>
            <translation>보정의 평균이 %1 um입니다.</translation>
        </message>
        <message>
            <source>The trim follows the depth error.</source>
            <translation>보정이 깊이 오차를 따라갑니다.</translation>
        </message>
        <message>
            <source>The turning loop does not know this controller.</source>
            <translation>선삭 루프가 모르는 제어기입니다.</translation>
        </message>
        <message>
            <source>Touch-off</source>
            <translation>터치오프</translation>
        </message>
        <message>
            <source>Trim authority</source>
            <translation>보정 허용 범위</translation>
        </message>
        <message>
            <source>Under control</source>
            <translation>제어 여부</translation>
        </message>
        <message>
            <source>this machine</source>
            <translation>이 기계</translation>
        </message>
        <message>
            <source>%1 taps in a row did not count: check the encoders.</source>
            <translation>탭 %1회가 연속으로 인정되지 않았습니다: 엔코더를 확인하십시오.</translation>
        </message>
        <message>
            <source>Error RMS</source>
            <translation>오차 RMS</translation>
        </message>
        <message>
            <source>Error p-p in the work</source>
            <translation>가공 구간 오차 p-p</translation>
        </message>
        <message>
            <source>In control the tap is turned out in sync and the gains are rolled back. The thread may be torn.</source>
            <translation>제어 중이면 탭을 동기하여 빼내고 게인을 되돌립니다. 나사가 뜯겼을 수 있습니다.</translation>
        </message>
        <message>
            <source>In control the tap is turned out in sync.</source>
            <translation>제어 중이면 탭을 동기하여 빼냅니다.</translation>
        </message>
        <message>
            <source>In control the tap is turned out in sync. It does not count.</source>
            <translation>제어 중이면 탭을 동기하여 빼냅니다. 이 탭은 인정되지 않습니다.</translation>
        </message>
        <message>
            <source>Largest error</source>
            <translation>최대 오차</translation>
        </message>
        <message>
            <source>More than 5 % of its samples are missing, or the loop was switched during the tap.</source>
            <translation>샘플의 5 % 이상이 없거나 탭 중에 루프가 전환되었습니다.</translation>
        </message>
        <message>
            <source>Sum of errors (SAEC)</source>
            <translation>오차 합(SAEC)</translation>
        </message>
        <message>
            <source>The control did not start the tapping program.</source>
            <translation>제어기가 탭 프로그램을 시작하지 않았습니다.</translation>
        </message>
        <message>
            <source>The depth must be from 1 to 200 revolutions.</source>
            <translation>깊이는 1~200회전이어야 합니다.</translation>
        </message>
        <message>
            <source>The drive did not take the gains.</source>
            <translation>드라이브가 게인을 받지 않았습니다.</translation>
        </message>
        <message>
            <source>The gear must be from 1 to 9.</source>
            <translation>기어는 1~9이어야 합니다.</translation>
        </message>
        <message>
            <source>The last tap does not count: repeat it.</source>
            <translation>마지막 탭은 인정되지 않습니다: 다시 하십시오.</translation>
        </message>
        <message>
            <source>The learned trim of these gains is not loaded.</source>
            <translation>이 게인의 학습된 보정이 로드되지 않았습니다.</translation>
        </message>
        <message>
            <source>The loop was switched before the tap began.</source>
            <translation>탭이 시작되기 전에 루프가 전환되었습니다.</translation>
        </message>
        <message>
            <source>The spindle speed must be from 10 to 20000 rpm.</source>
            <translation>주축 속도는 10~20000 rpm이어야 합니다.</translation>
        </message>
        <message>
            <source>The tap was called off before it began.</source>
            <translation>탭이 시작되기 전에 취소되었습니다.</translation>
        </message>
        <message>
            <source>The tapping loop is off: switch it to advise or control to abort the tap.</source>
            <translation>탭 루프가 꺼져 있습니다: 탭을 중단하려면 추천이나 제어로 전환하십시오.</translation>
        </message>
        <message>
            <source>This tap takes %1 s; at most %2 s can be recorded: a higher speed or less depth.</source>
            <translation>이 탭은 %1 s 걸립니다; 최대 %2 s까지 기록됩니다: 속도를 높이거나 깊이를 줄이십시오.</translation>
        </message>
        <message>
            <source>Tolerance used</source>
            <translation>공차 사용률</translation>
        </message>
        <message>
            <source>A day cannot be used; nothing has changed.</source>
            <translation>쓸 수 없는 날이 있습니다. 바뀐 것은 없습니다.</translation>
        </message>
        <message>
            <source>A gap sensor's zero is not a number.</source>
            <translation>갭 센서의 영점이 숫자가 아닙니다.</translation>
        </message>
        <message>
            <source>A model is being trained.</source>
            <translation>모델을 학습하고 있습니다.</translation>
        </message>
        <message>
            <source>A session is being recorded.</source>
            <translation>기록하고 있습니다.</translation>
        </message>
        <message>
            <source>A thermocouple is left out</source>
            <translation>열전대 하나를 제외했습니다</translation>
        </message>
        <message>
            <source>Check its plug and its mounting.</source>
            <translation>플러그와 부착 상태를 확인하십시오.</translation>
        </message>
        <message>
            <source>Check that external work offset is allowed at the control.</source>
            <translation>제어기에서 외부 공작물 오프셋이 허용되는지 확인하십시오.</translation>
        </message>
        <message>
            <source>Check the temperature module and its cable.</source>
            <translation>온도 모듈과 케이블을 확인하십시오.</translation>
        </message>
        <message>
            <source>Choose at least one day to train on.</source>
            <translation>학습할 날을 하나 이상 고르십시오.</translation>
        </message>
        <message>
            <source>Drift faster than the shift may follow</source>
            <translation>열변위가 허용 보정 속도보다 빠릅니다</translation>
        </message>
        <message>
            <source>Error the part allows</source>
            <translation>공작물 허용 오차</translation>
        </message>
        <message>
            <source>It is open, shorted, stuck, noisy or away from what its neighbours expect.</source>
            <translation>단선, 단락, 고착, 잡음이거나 이웃의 예상과 다릅니다.</translation>
        </message>
        <message>
            <source>Largest shift</source>
            <translation>최대 보정량</translation>
        </message>
        <message>
            <source>Largest shift in a minute</source>
            <translation>1분당 최대 보정량</translation>
        </message>
        <message>
            <source>Look at the thermocouples: heat does not move that fast.</source>
            <translation>열전대를 확인하십시오. 열은 그렇게 빨리 움직이지 않습니다.</translation>
        </message>
        <message>
            <source>Measure the origin now</source>
            <translation>지금 원점을 측정하십시오</translation>
        </message>
        <message>
            <source>Measure the origin, then set it anew or allow a larger shift.</source>
            <translation>원점을 측정한 뒤 새로 잡거나 더 큰 보정량을 허용하십시오.</translation>
        </message>
        <message>
            <source>Measure the origin; record this state and train again.</source>
            <translation>원점을 측정하고, 이 상태를 기록해 다시 학습하십시오.</translation>
        </message>
        <message>
            <source>More than two of the model's own thermocouples are left out.</source>
            <translation>모델이 쓰는 열전대가 셋 이상 제외되었습니다.</translation>
        </message>
        <message>
            <source>No session is being recorded.</source>
            <translation>기록 중이 아닙니다.</translation>
        </message>
        <message>
            <source>No temperatures from the machine</source>
            <translation>기계에서 온도가 오지 않습니다</translation>
        </message>
        <message>
            <source>Nothing can be predicted: too many thermocouples are left out.</source>
            <translation>예측할 수 없습니다. 제외된 열전대가 너무 많습니다.</translation>
        </message>
        <message>
            <source>Nothing has been measured yet.</source>
            <translation>아직 측정한 것이 없습니다.</translation>
        </message>
        <message>
            <source>Nothing is predicted; the last shift stays.</source>
            <translation>예측하지 않습니다. 마지막 보정량을 유지합니다.</translation>
        </message>
        <message>
            <source>One of the days is not there any more.</source>
            <translation>고른 날 하나가 없어졌습니다.</translation>
        </message>
        <message>
            <source>Outside the training range: the shift fades to hold. Measure the origin.</source>
            <translation>학습 범위 밖입니다. 보정은 서서히 유지로 바뀝니다. 원점을 측정하십시오.</translation>
        </message>
        <message>
            <source>Put the test bar in and measure from the thermal page.</source>
            <translation>테스트 바를 끼우고 열변위 화면에서 측정하십시오.</translation>
        </message>
        <message>
            <source>Repair the thermocouples named on the thermal page, or go live with a model without them.</source>
            <translation>열변위 화면에 표시된 열전대를 수리하거나 그것을 쓰지 않는 모델을 적용하십시오.</translation>
        </message>
        <message>
            <source>Shift of the work origin at its limit</source>
            <translation>공작물 원점 보정량이 한계입니다</translation>
        </message>
        <message>
            <source>Temperatures outside the training range</source>
            <translation>온도가 학습 범위를 벗어났습니다</translation>
        </message>
        <message>
            <source>The compensation fades to hold the last shift.</source>
            <translation>보정이 서서히 마지막 보정량 유지로 바뀝니다.</translation>
        </message>
        <message>
            <source>The control does not report its work offset; nothing is shifted.</source>
            <translation>제어기가 공작물 오프셋을 알려 주지 않아 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>The control does not take the shift</source>
            <translation>제어기가 보정량을 받지 않습니다</translation>
        </message>
        <message>
            <source>The drift is in the part.</source>
            <translation>열변위가 공작물에 그대로 남습니다.</translation>
        </message>
        <message>
            <source>The gap sensors have no zero yet: take a reference first.</source>
            <translation>갭 센서의 영점이 없습니다. 먼저 기준을 잡으십시오.</translation>
        </message>
        <message>
            <source>The gap sensors read nothing: end the program and put the test bar in the spindle.</source>
            <translation>갭 센서가 읽히지 않습니다. 프로그램을 끝내고 테스트 바를 주축에 끼우십시오.</translation>
        </message>
        <message>
            <source>The gap sensors stopped reading during the measurement.</source>
            <translation>측정 도중 갭 센서가 읽히지 않게 되었습니다.</translation>
        </message>
        <message>
            <source>The interval of the prediction is wider than the part allows.</source>
            <translation>예측 구간이 공작물 허용 오차보다 넓습니다.</translation>
        </message>
        <message>
            <source>The machine is in a state the model has never seen.</source>
            <translation>모델이 본 적 없는 기계 상태입니다.</translation>
        </message>
        <message>
            <source>The machine sends no temperatures any more.</source>
            <translation>기계가 더 이상 온도를 보내지 않습니다.</translation>
        </message>
        <message>
            <source>The machine sends no temperatures; the last shift stays.</source>
            <translation>기계가 온도를 보내지 않습니다. 마지막 보정량을 유지합니다.</translation>
        </message>
        <message>
            <source>The model goes on without it; its interval is wider.</source>
            <translation>모델은 그것 없이 계속하며 구간이 넓어집니다.</translation>
        </message>
        <message>
            <source>The new model runs through the day so far.</source>
            <translation>새 모델이 오늘 지난 시간을 따라가고 있습니다.</translation>
        </message>
        <message>
            <source>The origin is being measured.</source>
            <translation>원점을 측정하고 있습니다.</translation>
        </message>
        <message>
            <source>The predicted drift is larger than the largest shift allowed.</source>
            <translation>예측 열변위가 허용된 최대 보정량보다 큽니다.</translation>
        </message>
        <message>
            <source>The predicted drift moves faster than the rate allowed.</source>
            <translation>예측 열변위가 허용 속도보다 빨리 변합니다.</translation>
        </message>
        <message>
            <source>The rest of the drift is in the part.</source>
            <translation>나머지 열변위는 공작물에 남습니다.</translation>
        </message>
        <message>
            <source>The shift lags behind for some minutes.</source>
            <translation>보정이 몇 분 늦어집니다.</translation>
        </message>
        <message>
            <source>The shift may be wrong by more than the part allows.</source>
            <translation>보정이 공작물 허용 오차보다 크게 틀릴 수 있습니다.</translation>
        </message>
        <message>
            <source>The shift sits at its limit of size or rate.</source>
            <translation>보정량이 크기 또는 속도 한계에 있습니다.</translation>
        </message>
        <message>
            <source>The temperatures to count from are being taken; the shift stays.</source>
            <translation>기준 온도를 재고 있습니다. 보정량은 그대로입니다.</translation>
        </message>
        <message>
            <source>The thermal loop does not know this command.</source>
            <translation>열변위 루프가 모르는 명령입니다.</translation>
        </message>
        <message>
            <source>The thermal setup has a value outside its range; the last one stays.</source>
            <translation>열변위 설정에 범위를 벗어난 값이 있습니다. 이전 설정을 유지합니다.</translation>
        </message>
        <message>
            <source>The warm-up program needs speed and revolutions above zero.</source>
            <translation>예열 프로그램에는 0보다 큰 속도와 회전수가 필요합니다.</translation>
        </message>
        <message>
            <source>The work offset the control reports is not the one commanded.</source>
            <translation>제어기가 알려 준 공작물 오프셋이 명령한 값과 다릅니다.</translation>
        </message>
        <message>
            <source>The work origin follows the predicted drift.</source>
            <translation>공작물 원점이 예측 열변위를 따라갑니다.</translation>
        </message>
        <message>
            <source>There is no measurement beside a prediction yet.</source>
            <translation>예측과 함께 한 측정이 아직 없습니다.</translation>
        </message>
        <message>
            <source>There is no model before this one.</source>
            <translation>이전 모델이 없습니다.</translation>
        </message>
        <message>
            <source>There is no thermal model yet: train one.</source>
            <translation>열변위 모델이 아직 없습니다. 학습하십시오.</translation>
        </message>
        <message>
            <source>There is no trained model that waits to go live.</source>
            <translation>적용을 기다리는 학습된 모델이 없습니다.</translation>
        </message>
        <message>
            <source>Thermocouple %1 disagrees with its neighbours.</source>
            <translation>열전대 %1이(가) 이웃과 일치하지 않습니다.</translation>
        </message>
        <message>
            <source>Thermocouple %1 has jumped away from its neighbours.</source>
            <translation>열전대 %1의 값이 이웃에서 튀었습니다.</translation>
        </message>
        <message>
            <source>Thermocouple %1 is noisy.</source>
            <translation>열전대 %1에 잡음이 있습니다.</translation>
        </message>
        <message>
            <source>Thermocouple %1 is open.</source>
            <translation>열전대 %1이(가) 단선되었습니다.</translation>
        </message>
        <message>
            <source>Thermocouple %1 is shorted.</source>
            <translation>열전대 %1이(가) 단락되었습니다.</translation>
        </message>
        <message>
            <source>Thermocouple %1 is stuck.</source>
            <translation>열전대 %1이(가) 고착되었습니다.</translation>
        </message>
        <message>
            <source>This machine has no thermocouple %1; %2 of the model's %3 are missing.</source>
            <translation>이 기계에는 열전대 %1이(가) 없습니다. 모델의 %3개 중 %2개가 없습니다.</translation>
        </message>
        <message>
            <source>This measurement has been taken over already.</source>
            <translation>이 측정값은 이미 적용했습니다.</translation>
        </message>
        <message>
            <source>Time between two shifts</source>
            <translation>보정 주기</translation>
        </message>
        <message>
            <source>Too many thermocouples lost</source>
            <translation>열전대를 너무 많이 잃었습니다</translation>
        </message>
        <message>
            <source>Warm-up speed</source>
            <translation>예열 속도</translation>
        </message>
        <message>
            <source>Warm-up time</source>
            <translation>예열 시간</translation>
        </message>
        <message>
            <source>X screw</source>
            <translation>X 스크루</translation>
        </message>
        <message>
            <source>Y screw</source>
            <translation>Y 스크루</translation>
        </message>
        <message>
            <source>Z screw</source>
            <translation>Z 스크루</translation>
        </message>
        <message>
            <source>bed</source>
            <translation>베드</translation>
        </message>
        <message>
            <source>column, back</source>
            <translation>칼럼 뒤</translation>
        </message>
        <message>
            <source>column, foot</source>
            <translation>칼럼 아래</translation>
        </message>
        <message>
            <source>column, left</source>
            <translation>칼럼 왼쪽</translation>
        </message>
        <message>
            <source>column, right</source>
            <translation>칼럼 오른쪽</translation>
        </message>
        <message>
            <source>column, top</source>
            <translation>칼럼 위</translation>
        </message>
        <message>
            <source>front bearing</source>
            <translation>앞 베어링</translation>
        </message>
        <message>
            <source>head, left</source>
            <translation>헤드 왼쪽</translation>
        </message>
        <message>
            <source>head, right</source>
            <translation>헤드 오른쪽</translation>
        </message>
        <message>
            <source>quill</source>
            <translation>퀼</translation>
        </message>
        <message>
            <source>rear bearing</source>
            <translation>뒤 베어링</translation>
        </message>
        <message>
            <source>room</source>
            <translation>실내</translation>
        </message>
        <message>
            <source>saddle</source>
            <translation>새들</translation>
        </message>
        <message>
            <source>shaft</source>
            <translation>축</translation>
        </message>
        <message>
            <source>spindle motor</source>
            <translation>주축 모터</translation>
        </message>
        <message>
            <source>table</source>
            <translation>테이블</translation>
        </message>
        <message>
            <source>A subroutine needs a name of letters, digits and underscores, a number from 1 to 9999 and a deviation from 0.001 to 0.1.</source>
            <translation>서브프로그램에는 영문자, 숫자, 밑줄로 된 이름, 1에서 9999까지의 번호, 0.001에서 0.1까지의 편차가 필요합니다.</translation>
        </message>
        <message>
            <source>Diamond turning trims the tool every 0.2 ms; this control moves once per ms.</source>
            <translation>다이아몬드 선삭은 0.2 ms마다 공구를 보정하지만 이 제어기는 1 ms에 한 번 움직입니다.</translation>
        </message>
        <message>
            <source>LinuxCNC has not been reached yet: what it can do is not known.</source>
            <translation>아직 LinuxCNC에 연결되지 않아 할 수 있는 일을 알 수 없습니다.</translation>
        </message>
        <message>
            <source>Matched gain %1 1/s and feed-forward %2: %3 mm expected.</source>
            <translation>맞춘 게인 %1 1/s, 피드포워드 %2: 예상 %3 mm.</translation>
        </message>
        <message>
            <source>The gains do not read back from the control.</source>
            <translation>제어기에서 게인이 되읽히지 않습니다.</translation>
        </message>
        <message>
            <source>The gains of Z cannot be set on this LinuxCNC: add kerf-tapping.hal.</source>
            <translation>이 LinuxCNC에서는 Z 게인을 설정할 수 없습니다. kerf-tapping.hal을 추가하십시오.</translation>
        </message>
        <message>
            <source>The schedule has a value outside its range: feeds, overhangs, speed and alpha above zero.</source>
            <translation>이송 계획에 범위를 벗어난 값이 있습니다. 이송, 돌출 길이, 회전수, 알파는 0보다 커야 합니다.</translation>
        </message>
        <message>
            <source>The schedule needs more than %1 segments: allow a larger deviation.</source>
            <translation>이송 계획에 %1개보다 많은 구간이 필요합니다. 더 큰 편차를 허용하십시오.</translation>
        </message>
        <message>
            <source>The spindle's gain cannot be set on this control, only Z's.</source>
            <translation>이 제어기에서는 주축 게인을 설정할 수 없고 Z 게인만 설정할 수 있습니다.</translation>
        </message>
        <message>
            <source>The tapping program needs pitch and speed above zero and more than %1 revolutions.</source>
            <translation>탭 프로그램에는 0보다 큰 피치와 회전수, 그리고 %1회전보다 많은 회전이 필요합니다.</translation>
        </message>
        <message>
            <source>This LinuxCNC brings no cutting force: no sensor is connected.</source>
            <translation>이 LinuxCNC는 절삭력을 전달하지 않습니다. 연결된 센서가 없습니다.</translation>
        </message>
        <message>
            <source>This LinuxCNC brings no temperatures: without them nothing can be predicted.</source>
            <translation>이 LinuxCNC는 온도를 전달하지 않습니다. 온도 없이는 아무것도 예측할 수 없습니다.</translation>
        </message>
        <message>
            <source>This control cannot turn a standing tap out in sync: turn spindle and Z back by hand at the control, one pitch per revolution.</source>
            <translation>이 제어기는 서 있는 탭을 동기로 빼낼 수 없습니다. 제어기에서 주축과 Z를 회전당 한 피치씩 손으로 되돌리십시오.</translation>
        </message>
        <message>
            <source>What is left (%1 mm) is not a matter of gain or feed-forward.</source>
            <translation>남은 오차(%1 mm)는 게인이나 피드포워드의 문제가 아닙니다.</translation>
        </message>
        <message>
            <source>%1 parts are too few for indices; they begin at %2.</source>
            <translation>공작물 %1개로는 지수를 낼 수 없습니다. %2개부터 계산합니다.</translation>
        </message>
        <message>
            <source>%1 readings are too few; a type 1 study needs %2.</source>
            <translation>측정 %1회로는 부족합니다. 1형 게이지 평가에는 %2회가 필요합니다.</translation>
        </message>
        <message>
            <source>15 in a row within 1σ</source>
            <translation>15점 연속 1σ 이내</translation>
        </message>
        <message>
            <source>2 of 3 beyond 2σ</source>
            <translation>3점 중 2점이 2σ 밖</translation>
        </message>
        <message>
            <source>4 of 5 beyond 1σ</source>
            <translation>5점 중 4점이 1σ 밖</translation>
        </message>
        <message>
            <source>8 in a row beyond 1σ</source>
            <translation>8점 연속 1σ 밖</translation>
        </message>
        <message>
            <source>8 in a row on one side</source>
            <translation>8점 연속 한쪽</translation>
        </message>
        <message>
            <source>9 in a row on one side</source>
            <translation>9점 연속 한쪽</translation>
        </message>
        <message>
            <source>A crossed study needs at least 2 parts, 2 persons and 2 trials; it has %1, %2, %3.</source>
            <translation>교차 평가에는 공작물 2개, 측정자 2명, 반복 2회 이상이 필요합니다. 지금은 %1, %2, %3입니다.</translation>
        </message>
        <message>
            <source>All readings are alike: the gauge is stuck, or too coarse for a study.</source>
            <translation>측정값이 모두 같습니다. 게이지가 걸렸거나 평가하기에 분해능이 부족합니다.</translation>
        </message>
        <message>
            <source>All values are alike, so there are no indices: is the gauge too coarse?</source>
            <translation>값이 모두 같아 지수를 낼 수 없습니다. 게이지 분해능이 부족하지 않습니까?</translation>
        </message>
        <message>
            <source>Average and range takes at most %1 parts, persons or trials; use ANOVA.</source>
            <translation>평균-범위법은 공작물, 측정자, 반복을 각각 %1까지만 받습니다. 분산분석을 쓰십시오.</translation>
        </message>
        <message>
            <source>Field %1 of the model file has an unknown value.</source>
            <translation>모델 파일 항목 %1의 값을 알 수 없습니다.</translation>
        </message>
        <message>
            <source>Field %1 of the model file has the wrong length.</source>
            <translation>모델 파일 항목 %1의 길이가 맞지 않습니다.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is not a finite number.</source>
            <translation>모델 파일 항목 %1의 값이 유한한 수가 아닙니다.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is not a range from low to high.</source>
            <translation>모델 파일 항목 %1의 범위가 낮은 값에서 높은 값 순서가 아닙니다.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is not a text.</source>
            <translation>모델 파일 항목 %1은 글자여야 합니다.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is not a whole number in range.</source>
            <translation>모델 파일 항목 %1은 범위 안의 정수여야 합니다.</translation>
        </message>
        <message>
            <source>Field %1 of the model file is out of range.</source>
            <translation>모델 파일 항목 %1이 범위를 벗어났습니다.</translation>
        </message>
        <message>
            <source>Field %1 of the stored tuning is out of range.</source>
            <translation>저장된 조정값 항목 %1이 범위를 벗어났습니다.</translation>
        </message>
        <message>
            <source>The model file has another unit of %1; expected %2.</source>
            <translation>모델 파일의 %1 단위가 다릅니다. %2이어야 합니다.</translation>
        </message>
        <message>
            <source>The model file has no field %1.</source>
            <translation>모델 파일에 항목 %1이 없습니다.</translation>
        </message>
        <message>
            <source>The model file has version %1; this program reads up to version %2. Use a newer program.</source>
            <translation>모델 파일은 버전 %1이고 이 프로그램은 버전 %2까지 읽습니다. 새 프로그램을 쓰십시오.</translation>
        </message>
        <message>
            <source>The model file is damaged.</source>
            <translation>모델 파일이 손상되었습니다.</translation>
        </message>
        <message>
            <source>The residual chart shows a signal: these parts performed so, but it is no capability.</source>
            <translation>잔차 관리도에 이상 신호가 있습니다. 이 공작물들의 성능일 뿐 공정 능력은 아닙니다.</translation>
        </message>
        <message>
            <source>The stored tuning has no field %1.</source>
            <translation>저장된 조정값에 항목 %1이 없습니다.</translation>
        </message>
        <message>
            <source>The stored tuning is not JSON.</source>
            <translation>저장된 조정값이 JSON 형식이 아닙니다.</translation>
        </message>
        <message>
            <source>The stored tuning is of another version.</source>
            <translation>저장된 조정값의 버전이 다릅니다.</translation>
        </message>
        <message>
            <source>The study is not crossed: part %1, person %2, trial %3 must stand there once.</source>
            <translation>교차 평가가 아닙니다. 공작물 %1, 측정자 %2, 반복 %3이 한 번씩 있어야 합니다.</translation>
        </message>
        <message>
            <source>The tolerance must be above 0; it is %1.</source>
            <translation>공차는 0보다 커야 합니다. 지금은 %1입니다.</translation>
        </message>
        <message>
            <source>There is no tolerance, so there are no indices.</source>
            <translation>공차가 없어 지수를 낼 수 없습니다.</translation>
        </message>
        <message>
            <source>This is not a thermal model file.</source>
            <translation>열변위 모델 파일이 아닙니다.</translation>
        </message>
        <message>
            <source>one beyond 3σ</source>
            <translation>1점이 3σ 밖</translation>
        </message>
        <message>
            <source>The shop has been out of reach for %1 min; %2 entries wait here.</source>
            <translation>%1분 동안 공장 서버에 연결되지 않았습니다. 여기에 %2건이 대기 중입니다.</translation>
        </message>
        <message>
            <source>%1 finished parts are not recorded.</source>
            <translation>완성된 공작물 %1개가 기록되지 않았습니다.</translation>
        </message>
        <message>
            <source>%1 finished parts had waited beside the data file; they are stored now.</source>
            <translation>완성된 공작물 %1개가 데이터 파일 옆에서 기다리고 있었으며 이제 저장되었습니다.</translation>
        </message>
        <message>
            <source>%1 items that waited beside the data file are of another version: they are kept in a file beside it.</source>
            <translation>데이터 파일 옆에서 기다리던 항목 %1개는 다른 버전의 것입니다. 그 옆의 파일에 보관됩니다.</translation>
        </message>
        <message>
            <source>%1 setups, tunings and models were kept, %2 are stored.</source>
            <translation>설정·튜닝·모델 %1건이 보관되었으나 %2건만 저장되어 있습니다.</translation>
        </message>
        <message>
            <source>A finished part was not recorded</source>
            <translation>완성된 공작물이 기록되지 않았습니다</translation>
        </message>
        <message>
            <source>A part was begun at the control while finished parts could not be stored, and there is no place left to keep them.</source>
            <translation>완성된 공작물을 저장할 수 없는 동안 제어기에서 공작물이 시작되었고, 보관할 자리가 더 없습니다.</translation>
        </message>
        <message>
            <source>Audit entry %1 is not the one that had been written: this is another file.</source>
            <translation>감사 항목 %1이 기록했던 것과 다릅니다. 다른 파일입니다.</translation>
        </message>
        <message>
            <source>Begin no part at the control until storing goes on. Note these parts down by hand.</source>
            <translation>저장이 다시 될 때까지 제어기에서 공작물을 시작하지 마십시오. 이 공작물들은 손으로 적어 두십시오.</translation>
        </message>
        <message>
            <source>One of the first %1 kept setups, tunings or models was changed after it was kept.</source>
            <translation>처음 보관된 설정·튜닝·모델 %1건 중 하나가 보관된 뒤 바뀌었습니다.</translation>
        </message>
        <message>
            <source>Only a process engineer may do this.</source>
            <translation>공정 엔지니어만 할 수 있습니다.</translation>
        </message>
        <message>
            <source>Only a setter or a process engineer may do this.</source>
            <translation>셋업 담당자나 공정 엔지니어만 할 수 있습니다.</translation>
        </message>
        <message>
            <source>Recipe revision %1 differs from what was logged when it was saved.</source>
            <translation>레시피 개정 %1이 저장될 때 기록된 것과 다릅니다.</translation>
        </message>
        <message>
            <source>Record %1 (%2) differs from what was logged when it was kept.</source>
            <translation>기록 %1(%2)이 보관될 때 기록된 것과 다릅니다.</translation>
        </message>
        <message>
            <source>Setting %1 differs from what was logged when it was changed.</source>
            <translation>설정 %1이 변경될 때 기록된 것과 다릅니다.</translation>
        </message>
        <message>
            <source>The JSON holds %1; numbers are expected within ±1e60.</source>
            <translation>JSON에 %1이 있습니다. 수는 ±1e60 안이어야 합니다.</translation>
        </message>
        <message>
            <source>The JSON holds a number too large to be stored; numbers are expected within ±1e60.</source>
            <translation>JSON에 저장할 수 없을 만큼 큰 수가 있습니다. 수는 ±1e60 안이어야 합니다.</translation>
        </message>
        <message>
            <source>The JSON is nested deeper than %1 levels.</source>
            <translation>JSON이 %1단계보다 깊게 중첩되어 있습니다.</translation>
        </message>
        <message>
            <source>The data file was deleted, moved or replaced while Kerf runs: nothing is stored. Put it back, or end Kerf and start it anew; what waits is kept beside it.</source>
            <translation>Kerf 실행 중에 데이터 파일이 삭제·이동되거나 바뀌었습니다. 아무것도 저장되지 않습니다. 파일을 되돌려 놓거나 Kerf를 끝내고 다시 시작하십시오. 기다리는 항목은 그 옆에 보관됩니다.</translation>
        </message>
        <message>
            <source>The newest entries are missing: %1 had been written to the audit log, it ends at %2. A log file (-wal) was cut or deleted, or an older copy was put back.</source>
            <translation>최근 항목이 없습니다. 감사 기록은 %1까지 쓰였으나 %2에서 끝납니다. 로그 파일(-wal)이 잘리거나 삭제되었거나, 이전 사본이 놓였습니다.</translation>
        </message>
        <message>
            <source>The newest rows of %1 are missing: %2 had been written, %3 are left. A log file (-wal) was cut or deleted, or an older copy was put back.</source>
            <translation>%1의 최근 행이 없습니다. %2까지 쓰였으나 %3만 남아 있습니다. 로그 파일(-wal)이 잘리거나 삭제되었거나, 이전 사본이 놓였습니다.</translation>
        </message>
        <message>
            <source>This is not JSON: no valid JSON at byte %1.</source>
            <translation>JSON이 아닙니다. %1바이트에서 올바른 JSON이 아닙니다.</translation>
        </message>
        <message>
            <source>This part and those after it stand nowhere: neither figures nor feed of them are kept.</source>
            <translation>이 공작물과 그 뒤의 공작물은 어디에도 남지 않습니다. 수치도 이송도 보관되지 않습니다.</translation>
        </message>
        <message>
            <source>An abort came first: this was not sent any more.</source>
            <translation>중단이 먼저 왔습니다. 이 명령은 보내지 않았습니다.</translation>
        </message>
        <message>
            <source>Another program (process %1) commands this machine, this one only reads: end it, or take the machine over, and start this one anew.</source>
            <translation>다른 프로그램(프로세스 %1)이 이 기계를 지휘하고 있어 이 프로그램은 읽기만 합니다. 그것을 끝내거나 기계를 넘겨받은 뒤 이 프로그램을 다시 시작하십시오.</translation>
        </message>
        <message>
            <source>LinuxCNC is not reached: there is nobody to take it over from.</source>
            <translation>LinuxCNC에 연결되지 않았습니다. 넘겨받을 상대가 없습니다.</translation>
        </message>
        <message>
            <source>Others may read the file with the passwords of linuxcncrsh: give it mode 0600.</source>
            <translation>linuxcncrsh 암호 파일을 다른 사람이 읽을 수 있습니다. 권한을 0600으로 하십시오.</translation>
        </message>
        <message>
            <source>The control took the command, but no part began: see its own message (soft limit, tool, spindle).</source>
            <translation>제어기가 명령을 받았지만 공작물이 시작되지 않았습니다. 제어기의 메시지를 보십시오(소프트 리밋, 공구, 주축).</translation>
        </message>
        <message>
            <source>The file with the passwords of linuxcncrsh cannot be read.</source>
            <translation>linuxcncrsh 암호 파일을 읽을 수 없습니다.</translation>
        </message>
        <message>
            <source>The file with the passwords of linuxcncrsh needs two lines: connect and enable.</source>
            <translation>linuxcncrsh 암호 파일에는 connect와 enable 두 줄이 필요합니다.</translation>
        </message>
        <message>
            <source>The units of this LinuxCNC are not known ([TRAJ]LINEAR_UNITS): Kerf commands nothing before it knows them.</source>
            <translation>이 LinuxCNC의 단위([TRAJ]LINEAR_UNITS)를 알 수 없습니다. 알기 전에는 Kerf가 아무것도 지휘하지 않습니다.</translation>
        </message>
        <message>
            <source>This LinuxCNC counts in inches ([TRAJ]LINEAR_UNITS): Kerf commands machines in mm only, and reads this one.</source>
            <translation>이 LinuxCNC는 인치 단위([TRAJ]LINEAR_UNITS)입니다. Kerf는 mm 기계만 지휘하며 이 기계는 읽기만 합니다.</translation>
        </message>
        <message>
            <source>This machine is not shared: there is nobody to take it over from.</source>
            <translation>이 기계는 공유되지 않습니다. 넘겨받을 상대가 없습니다.</translation>
        </message>
        <message>
            <source>A move of Z or spindle alone breaks the tap. Kerf starts nothing and moves no axis until it is out.</source>
            <translation>Z축이나 주축만 움직이면 탭이 부러집니다. 탭이 빠질 때까지 Kerf는 아무것도 시작하지 않고 축을 움직이지 않습니다.</translation>
        </message>
        <message>
            <source>A stop stands from before: see the alarm.</source>
            <translation>이전의 정지가 남아 있습니다: 알람을 보십시오.</translation>
        </message>
        <message>
            <source>A stop stands: look at the machine, then release the stop.</source>
            <translation>정지가 걸려 있습니다: 기계를 확인한 뒤 정지를 해제하십시오.</translation>
        </message>
        <message>
            <source>A tap stands in the hole, from before Kerf was started: turn it out in sync.</source>
            <translation>Kerf를 시작하기 전부터 탭이 구멍에 있습니다: 동기로 빼내십시오.</translation>
        </message>
        <message>
            <source>A tap stands in the hole: turn it out first, or say that it is gone.</source>
            <translation>탭이 구멍에 있습니다: 먼저 빼내거나 없어졌다고 알리십시오.</translation>
        </message>
        <message>
            <source>All loops are held. The control goes on with its last offset, at most at the planned feed; a program without one is held.</source>
            <translation>모든 루프가 보류되었습니다. 제어기는 마지막 보정을 유지하고 최대 계획 이송으로 계속하며, 계획 이송이 없는 프로그램은 멈춥니다.</translation>
        </message>
        <message>
            <source>Called off before it began.</source>
            <translation>시작되기 전에 취소되었습니다.</translation>
        </message>
        <message>
            <source>Check sensor, amplifier and cable. Measure this surface. Then release the stop.</source>
            <translation>센서, 증폭기, 케이블을 점검하고 이 면을 측정한 뒤 정지를 해제하십시오.</translation>
        </message>
        <message>
            <source>Check the control and the cable. Kerf connects again by itself; look at the machine, then release the hold.</source>
            <translation>제어기와 케이블을 점검하십시오. Kerf는 스스로 다시 연결됩니다. 기계를 확인한 뒤 보류를 해제하십시오.</translation>
        </message>
        <message>
            <source>Find out why the spindle stopped. When it turns again, release the stop on the Milling page.</source>
            <translation>주축이 멈춘 원인을 찾으십시오. 다시 돌면 밀링 화면에서 정지를 해제하십시오.</translation>
        </message>
        <message>
            <source>Kerf has come while a program runs: look at the machine, then release the hold.</source>
            <translation>프로그램이 도는 중에 Kerf가 시작되었습니다: 기계를 확인한 뒤 보류를 해제하십시오.</translation>
        </message>
        <message>
            <source>Look at the tool's edge. Change it if it is chipped, then release the stop.</source>
            <translation>공구 날을 확인하십시오. 이가 빠졌으면 교체한 뒤 정지를 해제하십시오.</translation>
        </message>
        <message>
            <source>Look at tool and blank. If both are sound, raise the limit or lower the reference, then release the stop on the Milling page.</source>
            <translation>공구와 소재를 확인하십시오. 둘 다 이상이 없으면 한계를 올리거나 기준을 낮춘 뒤 밀링 화면에서 정지를 해제하십시오.</translation>
        </message>
        <message>
            <source>Make the machine ready, then turn the tap out in sync from the tapping page; or say there that it is gone.</source>
            <translation>기계를 준비한 뒤 태핑 화면에서 탭을 동기로 빼내거나, 탭이 없어졌다고 알리십시오.</translation>
        </message>
        <message>
            <source>Make the machine safe, reset the emergency stop at the control, look, then release the hold.</source>
            <translation>기계를 안전하게 하고 제어기에서 비상정지를 풀고 확인한 뒤 보류를 해제하십시오.</translation>
        </message>
        <message>
            <source>No connection to the machine: nothing was asked of it.</source>
            <translation>기계와 연결되지 않았습니다: 아무것도 요청하지 않았습니다.</translation>
        </message>
        <message>
            <source>No connection to the machine: the last offset stays, the feed is at most the planned one, or held.</source>
            <translation>기계와 연결되지 않았습니다: 마지막 보정은 유지되고 이송은 계획 이송 이하이거나 멈춥니다.</translation>
        </message>
        <message>
            <source>No stop stands here.</source>
            <translation>걸려 있는 정지가 없습니다.</translation>
        </message>
        <message>
            <source>Programmed feed unknown: no faster than the schedule's lowest feed.</source>
            <translation>프로그램 이송을 알 수 없습니다: 스케줄의 최저 이송을 넘지 않습니다.</translation>
        </message>
        <message>
            <source>Retract and look at the tool. Change it if it is broken, then release the stop on the Milling page.</source>
            <translation>후퇴하여 공구를 확인하십시오. 부러졌으면 교체한 뒤 밀링 화면에서 정지를 해제하십시오.</translation>
        </message>
        <message>
            <source>Sign on first: a stop is released by a person.</source>
            <translation>먼저 로그인하십시오: 정지는 사람이 해제합니다.</translation>
        </message>
        <message>
            <source>Spindle overhang unknown: no faster than the schedule's lowest feed.</source>
            <translation>주축 돌출 길이를 알 수 없습니다: 스케줄의 최저 이송을 넘지 않습니다.</translation>
        </message>
        <message>
            <source>Spindle speed unknown or zero: no faster than the schedule's lowest feed.</source>
            <translation>주축 속도를 알 수 없거나 0입니다: 스케줄의 최저 이송을 넘지 않습니다.</translation>
        </message>
        <message>
            <source>Stopped again since the release was asked: look once more.</source>
            <translation>해제를 요청한 뒤 다시 정지되었습니다: 한 번 더 확인하십시오.</translation>
        </message>
        <message>
            <source>The connection was lost: look at the machine, then release the hold.</source>
            <translation>연결이 끊겼었습니다: 기계를 확인한 뒤 보류를 해제하십시오.</translation>
        </message>
        <message>
            <source>The connection was lost: no trim in the rest of this part.</source>
            <translation>연결이 끊겼었습니다: 이 공작물의 나머지는 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>The control has ended the program. All loops are held until a person has looked; stops stay.</source>
            <translation>제어기가 프로그램을 끝냈습니다. 사람이 확인할 때까지 모든 루프가 보류되며, 정지는 남아 있습니다.</translation>
        </message>
        <message>
            <source>The feed falls to the lowest of the schedule and does not follow it, so the bore may taper.</source>
            <translation>이송이 스케줄의 최저값으로 내려가 스케줄을 따르지 않으므로 내경에 테이퍼가 생길 수 있습니다.</translation>
        </message>
        <message>
            <source>The feed is held: see the alarm, then release the stop.</source>
            <translation>이송이 멈춰 있습니다: 알람을 확인한 뒤 정지를 해제하십시오.</translation>
        </message>
        <message>
            <source>The machine was switched off: look at it, then release the hold.</source>
            <translation>기계가 꺼졌었습니다: 기계를 확인한 뒤 보류를 해제하십시오.</translation>
        </message>
        <message>
            <source>The trim has gone to zero; the cut goes on without force feedback. No part is started until a person has released the stop.</source>
            <translation>보정이 0이 되었고 절삭은 힘 피드백 없이 계속됩니다. 사람이 정지를 해제할 때까지 공작물을 시작하지 않습니다.</translation>
        </message>
        <message>
            <source>The trim has gone to zero; the surface after the jump is doubtful. No part is started until a person has released the stop.</source>
            <translation>보정이 0이 되었고 급변 이후의 면은 의심스럽습니다. 사람이 정지를 해제할 때까지 공작물을 시작하지 않습니다.</translation>
        </message>
        <message>
            <source>There was an emergency stop: look at the machine, then release the hold.</source>
            <translation>비상정지가 있었습니다: 기계를 확인한 뒤 보류를 해제하십시오.</translation>
        </message>
        <message>
            <source>This loop may not ask the machine for that.</source>
            <translation>이 루프는 기계에 그것을 요청할 수 없습니다.</translation>
        </message>
        <message>
            <source>Too many requests wait for the machine.</source>
            <translation>기계를 기다리는 요청이 너무 많습니다.</translation>
        </message>
        <message>
            <source>Under control the feed is held, in every mode from then on; advising, Kerf only reports it. Nothing is started until a person has released the stop.</source>
            <translation>제어 중이면 이송이 멈추고 그 뒤 어떤 모드에서도 멈춰 있습니다. 추천 중이면 알리기만 합니다. 사람이 정지를 해제할 때까지 아무것도 시작하지 않습니다.</translation>
        </message>
        <message>
            <source>The table is in doubt: save it with ; between its columns, or with decimal points.</source>
            <translation>표를 어떻게 읽어야 할지 분명하지 않습니다. 열 사이를 ;로 하거나 소수점을 점으로 하여 저장하십시오.</translation>
        </message>
        <message>
            <source>angle_rev turns %1 rev between samples; revolutions expected, at most %2 between samples. A column in degrees is named angle_deg.</source>
            <translation>angle_rev가 샘플 사이에 %1회전합니다. 회전 수 단위로 샘플 사이 %2회전 이하여야 합니다. 각도(도) 열의 이름은 angle_deg입니다.</translation>
        </message>
        <message>
            <source>angle_rev means %1 rpm; at most %2 rpm are expected. A column in degrees is named angle_deg.</source>
            <translation>angle_rev에 따르면 %1 rpm입니다. %2 rpm 이하여야 합니다. 각도(도) 열의 이름은 angle_deg입니다.</translation>
        </message>
        <message>
            <source>the spindle's angle jumps by %1 rev at sample %2; expected an angle that rises, falls or begins again after whole revolutions.</source>
            <translation>주축 각도가 샘플 %2에서 %1회전 건너뜁니다. 각도는 늘거나 줄거나 정수 회전마다 다시 시작해야 합니다.</translation>
        </message>
        <message>
            <source>the spindle's angle does not move in the whole record.</source>
            <translation>기록 전체에서 주축 각도가 움직이지 않습니다.</translation>
        </message>
        <message>
            <source>the spindle turns %1 rev one way and %2 rev the other; expected a cut in one direction.</source>
            <translation>주축이 한쪽으로 %1회전, 반대쪽으로 %2회전합니다. 한 방향으로 가공한 기록이어야 합니다.</translation>
        </message>
        <message>
            <source>%1 is no figure of this process.</source>
            <translation>이 공정에 없는 수치입니다: %1</translation>
        </message>
        <message>
            <source>%1 parts on the charts: too few to say whether the process is in control.</source>
            <translation>관리도의 공작물 %1개로는 관리 상태를 판단하기에 부족합니다.</translation>
        </message>
        <message>
            <source>A change is announced for part %1: it begins from what such changes have brought.</source>
            <translation>공작물 %1에 변경이 예고되었습니다. 그런 변경이 지금까지 가져온 결과에서 시작합니다.</translation>
        </message>
        <message>
            <source>A gauge needs an identity.</source>
            <translation>게이지 관리 번호가 필요합니다.</translation>
        </message>
        <message>
            <source>A part is being bored; announce the change when it is finished.</source>
            <translation>공작물을 보링하는 중입니다. 끝난 뒤에 변경을 예고하십시오.</translation>
        </message>
        <message>
            <source>All repeated readings are alike: the gauge is stuck, or too coarse for a study.</source>
            <translation>반복 측정값이 모두 같습니다. 게이지가 걸렸거나 평가하기에 분해능이 부족합니다.</translation>
        </message>
        <message>
            <source>Begin from earlier lots (1 yes, 0 no)</source>
            <translation>이전 로트에서 시작 (1 예, 0 아니오)</translation>
        </message>
        <message>
            <source>Expected from %1 earlier lots; the bending of a new tool differs by ± %2 % (1σ).</source>
            <translation>이전 로트 %1개로 예상한 값입니다. 새 공구의 휨은 ± %2 % (1σ) 다릅니다.</translation>
        </message>
        <message>
            <source>Expected from the %1 measured parts of this lot.</source>
            <translation>이 로트에서 측정한 공작물 %1개로 예상한 값입니다.</translation>
        </message>
        <message>
            <source>Expected from this lot and %1 earlier ones; after such a change the bending differs by ± %2 % (1σ).</source>
            <translation>이 로트와 이전 로트 %1개로 예상한 값입니다. 이런 변경 뒤에는 휨이 ± %2 % (1σ) 다릅니다.</translation>
        </message>
        <message>
            <source>First part teaches (1 yes, 0 no)</source>
            <translation>첫 공작물로 학습 (1 예, 0 아니오)</translation>
        </message>
        <message>
            <source>In control: the law predicts the parts, and the controller does not work harder.</source>
            <translation>관리 상태: 예측이 공작물과 맞고 제어기의 조작량도 늘지 않았습니다.</translation>
        </message>
        <message>
            <source>In control: the law predicts the parts. The controller has moved the feed by %1 % since part %2: the tool wears.</source>
            <translation>관리 상태: 예측이 공작물과 맞습니다. 제어기가 공작물 %2부터 이송을 %1 % 옮겼습니다. 공구가 마모되고 있습니다.</translation>
        </message>
        <message>
            <source>Not in control: %1 at part %2; look at tool, gauge and blank of that part.</source>
            <translation>관리 이탈: 공작물 %2에서 %1. 그 공작물의 공구, 게이지, 소재를 확인하십시오.</translation>
        </message>
        <message>
            <source>Nothing is known yet: the feed falls from %1 to %2 mm/rev near the bottom, so that this part shows what the feed does. Measure it in the middle too.</source>
            <translation>아직 알려진 것이 없습니다. 이송의 영향을 알 수 있도록 바닥 근처에서 이송을 %1에서 %2 mm/rev로 낮춥니다. 가운데도 측정하십시오.</translation>
        </message>
        <message>
            <source>Nothing is measured in this lot yet: it begins from the lots before it.</source>
            <translation>이 로트에는 아직 측정값이 없습니다. 이전 로트에서 시작합니다.</translation>
        </message>
        <message>
            <source>Part %1 contradicts what was expected from the past: the past is let go, the law learned anew.</source>
            <translation>공작물 %1이 과거에서 예상한 것과 다릅니다. 과거를 버리고 법칙을 새로 학습합니다.</translation>
        </message>
        <message>
            <source>Prior: feed exponent α</source>
            <translation>사전값: 이송 지수 α</translation>
        </message>
        <message>
            <source>Prior: ln C</source>
            <translation>사전값: ln C</translation>
        </message>
        <message>
            <source>Prior: overhang exponent β</source>
            <translation>사전값: 돌출 길이 지수 β</translation>
        </message>
        <message>
            <source>Prior: spread of the level</source>
            <translation>사전값: 수준의 산포</translation>
        </message>
        <message>
            <source>Prior: spread of α</source>
            <translation>사전값: α의 산포</translation>
        </message>
        <message>
            <source>Prior: spread of β</source>
            <translation>사전값: β의 산포</translation>
        </message>
        <message>
            <source>The first part of a lot counts as cut with a new tool already.</source>
            <translation>로트의 첫 공작물은 이미 새 공구로 가공하는 것으로 봅니다.</translation>
        </message>
        <message>
            <source>The limits of the figures cannot be read; they need numbers under their keys.</source>
            <translation>수치의 한계를 읽을 수 없습니다. 각 이름에 숫자가 있어야 합니다.</translation>
        </message>
        <message>
            <source>The lower limit of %1 must be below the upper one.</source>
            <translation>%1의 하한은 상한보다 작아야 합니다.</translation>
        </message>
        <message>
            <source>The range of a gauge must begin below its end, between 0 and 10000 mm.</source>
            <translation>게이지 측정 범위는 0~10000 mm 안에서 시작이 끝보다 작아야 합니다.</translation>
        </message>
        <message>
            <source>The resolution of a gauge lies above 0 and at most 1 mm.</source>
            <translation>게이지 분해능은 0보다 크고 1 mm 이하여야 합니다.</translation>
        </message>
        <message>
            <source>The setting ring must lie in the range of the gauge.</source>
            <translation>세팅 링은 게이지 측정 범위 안에 있어야 합니다.</translation>
        </message>
        <message>
            <source>The trim follows what can be foreseen of the disturbance.</source>
            <translation>보정이 외란의 예측 가능한 부분을 따릅니다.</translation>
        </message>
        <message>
            <source>There is no such gauge.</source>
            <translation>그런 게이지가 없습니다.</translation>
        </message>
        <message>
            <source>This lot does not begin from earlier ones; a change is found by its bores.</source>
            <translation>이 로트는 이전 로트에서 시작하지 않습니다. 변경은 내경으로 찾아냅니다.</translation>
        </message>
        <message>
            <source>wide guess for any boring spindle about table 1 of Lee (1983)</source>
            <translation>Lee(1983) 표 1을 중심으로 한 모든 보링 주축의 넓은 추정</translation>
        </message>
        <message>
            <source>A recorded day is played: nothing can be commanded.</source>
            <translation>기록된 하루를 재생 중입니다. 명령할 수 없습니다.</translation>
        </message>
        <message>
            <source>Jumped; believed again when three readings agree.</source>
            <translation>값이 튀었습니다. 세 번 연속 일치하면 다시 믿습니다.</translation>
        </message>
        <message>
            <source>No answer: the module is off, its cable is out, or the address is wrong.</source>
            <translation>응답 없음: 모듈이 꺼져 있거나 케이블이 빠졌거나 주소가 잘못되었습니다.</translation>
        </message>
        <message>
            <source>No drift was measured on that day.</source>
            <translation>그날은 변위를 측정하지 않았습니다.</translation>
        </message>
        <message>
            <source>No signal is linked to the pin.</source>
            <translation>핀에 연결된 신호가 없습니다.</translation>
        </message>
        <message>
            <source>Not read yet.</source>
            <translation>아직 읽지 않았습니다.</translation>
        </message>
        <message>
            <source>Outside what it can be: wrong type, scale or word order?</source>
            <translation>있을 수 없는 값입니다. 형식, 배율 또는 워드 순서가 잘못되었습니까?</translation>
        </message>
        <message>
            <source>Reads.</source>
            <translation>읽는 중입니다.</translation>
        </message>
        <message>
            <source>That is not on the picture.</source>
            <translation>그림 밖입니다.</translation>
        </message>
        <message>
            <source>The control reports a fault of this channel.</source>
            <translation>제어기가 이 채널의 고장을 알립니다.</translation>
        </message>
        <message>
            <source>The module has no such register: another one than the sensor file says.</source>
            <translation>모듈에 그런 레지스터가 없습니다. 센서 파일과 다른 모듈입니다.</translation>
        </message>
        <message>
            <source>The module says that there is no measurement: the thermocouple is broken or loose.</source>
            <translation>모듈이 측정값이 없다고 합니다. 열전대가 끊어졌거나 느슨합니다.</translation>
        </message>
        <message>
            <source>The module's status says that the value is not to be used.</source>
            <translation>모듈의 상태가 이 값을 쓰지 말라고 합니다.</translation>
        </message>
        <message>
            <source>The reading process does not run; it is started again.</source>
            <translation>읽기 프로세스가 실행되고 있지 않습니다. 다시 시작합니다.</translation>
        </message>
        <message>
            <source>The reading process kerf-sensors cannot be started: it is not beside the program, or the computer has no room for it.</source>
            <translation>읽기 프로세스 kerf-sensors를 시작할 수 없습니다. 프로그램 옆에 없거나 컴퓨터에 여유가 없습니다.</translation>
        </message>
        <message>
            <source>The recorded day is refused; the log says where and why.</source>
            <translation>기록된 하루를 읽을 수 없습니다. 위치와 이유는 로그에 있습니다.</translation>
        </message>
        <message>
            <source>The register holds no number: are its words swapped?</source>
            <translation>레지스터에 숫자가 없습니다. 워드 순서가 바뀌었습니까?</translation>
        </message>
        <message>
            <source>The sensor file is refused; `kerf sensors check` says where and why.</source>
            <translation>센서 파일을 받아들일 수 없습니다. `kerf sensors check`가 위치와 이유를 알려 줍니다.</translation>
        </message>
        <message>
            <source>nothing takes a connection there; expected a Modbus TCP module that is switched on.</source>
            <translation>그곳에서 연결을 받는 것이 없습니다. 켜져 있는 Modbus TCP 모듈이 필요합니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: Z reaches only %3 rev/s² and cannot follow the programmed ramp.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. Z가 %3 rev/s²밖에 내지 못해 프로그램된 가속을 따르지 못합니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: a resonance of Z bounds its gain.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. Z의 공진이 게인을 제한합니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: all taps are used.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. 탭을 모두 사용했습니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: lag in Z bounds its gain.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. Z의 지연이 게인을 제한합니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: the recorded signals are too noisy (%3 µm) to learn from.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. 기록된 신호의 잡음(%3 µm)이 커서 학습할 수 없습니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: the slow tick of the position loop bounds the gain of Z.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. 위치 루프의 느린 주기가 Z의 게인을 제한합니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: the spindle reaches only %3 rev/s² and cannot follow the programmed ramp.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. 주축이 %3 rev/s²밖에 내지 못해 프로그램된 가속을 따르지 못합니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: the trim of Z cannot take more.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. Z의 보정을 더 줄 수 없습니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: this tuner changes the gain alone.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. 이 튜너는 게인만 바꿉니다.</translation>
        </message>
        <message>
            <source>%1 µm is left, %2 µm is allowed: what is left differs from tap to tap.</source>
            <translation>%1 µm가 남았고 허용값은 %2 µm입니다. 남은 오차는 탭마다 다릅니다.</translation>
        </message>
        <message>
            <source>A faster velocity loop of Z, or a lower speed.</source>
            <translation>Z 속도 루프를 더 빠르게 하거나 회전수를 낮추십시오.</translation>
        </message>
        <message>
            <source>A filter at the resonance in the drive of Z, or a lower speed.</source>
            <translation>Z 드라이브에 공진 주파수 필터를 넣거나 회전수를 낮추십시오.</translation>
        </message>
        <message>
            <source>A lower gear, or a tap that needs less torque.</source>
            <translation>더 낮은 기어를 쓰거나 토크가 덜 드는 탭을 쓰십시오.</translation>
        </message>
        <message>
            <source>A lower speed, an even load, or a sharp tap.</source>
            <translation>회전수를 낮추거나, 부하를 고르게 하거나, 날카로운 탭을 쓰십시오.</translation>
        </message>
        <message>
            <source>A lower speed, or a control that takes a trim of the Z command.</source>
            <translation>회전수를 낮추거나 Z 지령 보정을 받는 제어기를 쓰십시오.</translation>
        </message>
        <message>
            <source>A shorter tick of the control's position loop, or a lower speed.</source>
            <translation>제어기의 위치 루프 주기를 줄이거나 회전수를 낮추십시오.</translation>
        </message>
        <message>
            <source>Finer encoders, or a filter on the recorded positions.</source>
            <translation>더 정밀한 엔코더를 쓰거나 기록된 위치에 필터를 넣으십시오.</translation>
        </message>
        <message>
            <source>Program a ramp of %1 rev/s², then tune again: %2 s per hole instead of %3 s.</source>
            <translation>가속을 %1 rev/s²로 프로그램한 뒤 다시 튜닝하십시오. 구멍당 %3 s가 아니라 %2 s가 걸립니다.</translation>
        </message>
        <message>
            <source>The default tuner, which learns feed-forward and trim too.</source>
            <translation>피드포워드와 보정까지 학습하는 기본 튜너를 쓰십시오.</translation>
        </message>
        <message>
            <source>Tune again from here: it goes on with what it has learned.</source>
            <translation>여기에서 다시 튜닝하십시오. 학습한 것에서 이어집니다.</translation>
        </message>
        <message>
            <source>%1 cannot be written.</source>
            <translation>%1에 쓸 수 없습니다.</translation>
        </message>
        <message>
            <source>A Q-DAS file was not written</source>
            <translation>Q-DAS 파일을 쓰지 못했습니다</translation>
        </message>
        <message>
            <source>A file name may hold {type}, {lot}, {part}, {serial}, {machine}, {date} and {time}, and no folder.</source>
            <translation>파일 이름에는 {type}, {lot}, {part}, {serial}, {machine}, {date}, {time}을 쓸 수 있으며 폴더는 쓸 수 없습니다.</translation>
        </message>
        <message>
            <source>A gauge is overdue</source>
            <translation>게이지의 검교정 기한이 지났습니다</translation>
        </message>
        <message>
            <source>A part is out of tolerance</source>
            <translation>공작물이 공차를 벗어났습니다</translation>
        </message>
        <message>
            <source>Gauge %1</source>
            <translation>게이지 %1</translation>
        </message>
        <message>
            <source>Have it checked, and enter the new date on the Quality page under Gauges.</source>
            <translation>검교정을 받고 품질 화면의 게이지에 새 날짜를 입력하세요.</translation>
        </message>
        <message>
            <source>In control: the figures of the parts spread by chance.</source>
            <translation>관리 상태: 공작물의 값은 우연히 흩어져 있습니다.</translation>
        </message>
        <message>
            <source>In control: the law predicts the parts. The last signal was %1 at part %2.</source>
            <translation>관리 상태: 법칙이 공작물을 예측합니다. 마지막 신호는 %2번 공작물의 %1입니다.</translation>
        </message>
        <message>
            <source>Its readings are taken as before, but nobody vouches for them.</source>
            <translation>측정값은 전과 같이 받아들이지만 보증하는 사람이 없습니다.</translation>
        </message>
        <message>
            <source>Look at tool, blank and gauge of that part. Announce a change on the Boring page.</source>
            <translation>그 공작물의 공구, 소재, 게이지를 확인하세요. 바뀐 것이 있으면 보링 화면에서 알리세요.</translation>
        </message>
        <message>
            <source>Make the folder reachable. The file is tried again with the next part.</source>
            <translation>폴더에 접근할 수 있게 하세요. 다음 공작물 때 다시 시도합니다.</translation>
        </message>
        <message>
            <source>Measure it again. Set the part aside and say on the Quality page what was done with it.</source>
            <translation>다시 측정하세요. 공작물을 따로 두고 어떻게 처리했는지 품질 화면에 기록하세요.</translation>
        </message>
        <message>
            <source>Part %1 can be cut again.</source>
            <translation>%1번 공작물은 재가공할 수 있습니다.</translation>
        </message>
        <message>
            <source>Part %1 is scrap.</source>
            <translation>%1번 공작물은 불량입니다.</translation>
        </message>
        <message>
            <source>Part %1: %2.</source>
            <translation>%1번 공작물: %2.</translation>
        </message>
        <message>
            <source>Parts may leave the tolerance sooner than the loop can follow. No capability is claimed.</source>
            <translation>루프가 따라가기 전에 공작물이 공차를 벗어날 수 있습니다. 공정 능력은 주장하지 않습니다.</translation>
        </message>
        <message>
            <source>Something has changed that the law does not know: insert, material, clamping, gauge.</source>
            <translation>법칙이 모르는 변화가 있습니다: 인서트, 소재, 클램핑, 게이지.</translation>
        </message>
        <message>
            <source>The date until which it was checked has passed.</source>
            <translation>검교정 유효 날짜가 지났습니다.</translation>
        </message>
        <message>
            <source>The file name must hold {part} or {serial}: each part has a file of its own.</source>
            <translation>파일 이름에는 {part} 또는 {serial}이 있어야 합니다. 공작물마다 파일이 하나씩 있습니다.</translation>
        </message>
        <message>
            <source>The folder is not there, is full, or may not be written to.</source>
            <translation>폴더가 없거나 가득 찼거나 쓸 권한이 없습니다.</translation>
        </message>
        <message>
            <source>The law no longer predicts the parts</source>
            <translation>법칙이 더 이상 공작물을 예측하지 못합니다</translation>
        </message>
        <message>
            <source>The lot has no parts yet.</source>
            <translation>로트에 아직 공작물이 없습니다.</translation>
        </message>
        <message>
            <source>The part waits for a decision. The loop goes on and learns from the value.</source>
            <translation>공작물이 처리 결정을 기다립니다. 루프는 계속되며 이 값에서 배웁니다.</translation>
        </message>
        <message>
            <source>The values are stored here; the system that reads the folder does not have them.</source>
            <translation>값은 여기에 저장되어 있지만 폴더를 읽는 시스템에는 없습니다.</translation>
        </message>
        <message>
            <source>Tool, blank, clamping or gauge: the charts of the Quality page say whether it stands alone.</source>
            <translation>공구, 소재, 클램핑 또는 게이지: 이 공작물만의 문제인지 품질 화면의 관리도가 알려 줍니다.</translation>
        </message>
        <message>
            <source>%1 has the drift of other axes than %2; train with days of the same axes.</source>
            <translation>%1의 드리프트 축이 %2와 다릅니다. 같은 축의 날들로 학습하십시오.</translation>
        </message>
        <message>
            <source>A hierarchical model needs at least two days; train a network, or record another day.</source>
            <translation>계층 모델에는 최소 이틀의 데이터가 필요합니다. 네트워크를 학습하거나 하루를 더 기록하십시오.</translation>
        </message>
        <message>
            <source>no measured drift; training needs at least one of yx_meas, yy_meas and yz_meas.</source>
            <translation>측정된 드리프트가 없습니다. 학습에는 yx_meas, yy_meas, yz_meas 중 하나 이상이 필요합니다.</translation>
        </message>
        <message>
            <source>accepted under concession</source>
            <translation>특채</translation>
        </message>
        <message>
            <source>reworked</source>
            <translation>재가공함</translation>
        </message>
        <message>
            <source>scrapped</source>
            <translation>폐기함</translation>
        </message>
        <message>
            <source>Setting ring of a comparator (0: it shows diameters)</source>
            <translation>비교 측정기의 세팅 링 (0: 지름을 직접 표시)</translation>
        </message>
        <message>
            <source>The samples are %1 s apart, at most %2 s are expected: is the time in ms?</source>
            <translation>샘플 간격이 %1 s이며 최대 %2 s여야 합니다. 시간이 ms 단위입니까?</translation>
        </message>
        <message>
            <source>Measure the origin every hour; record this state and train again.</source>
            <translation>매시간 원점을 측정하십시오. 이 상태를 기록하고 다시 학습하십시오.</translation>
        </message>
        <message>
            <source>The interval is wider; the model learns from every measurement.</source>
            <translation>구간이 넓어집니다. 모델은 모든 측정값에서 학습합니다.</translation>
        </message>
        <message>
            <source>The measurements of today fit a machine that behaves otherwise.</source>
            <translation>오늘의 측정값은 다르게 거동하는 기계에 들어맞습니다.</translation>
        </message>
        <message>
            <source>The model has learnt from this measurement already.</source>
            <translation>모델이 이미 이 측정값을 학습했습니다.</translation>
        </message>
        <message>
            <source>Today differs from the days trained on: measure</source>
            <translation>오늘은 학습한 날들과 다릅니다: 측정하십시오</translation>
        </message>
        <message>
            <source>Today differs from the days trained on: measure.</source>
            <translation>오늘은 학습한 날들과 다릅니다: 측정하십시오.</translation>
        </message>
        <message>
            <source>14 alternating</source>
            <translation>14개 연속 교대</translation>
        </message>
        <message>
            <source>6 rising or falling</source>
            <translation>6개 연속 증가 또는 감소</translation>
        </message>
        <message>
            <source>There is no such tool.</source>
            <translation>그런 공구가 없습니다.</translation>
        </message>
        <message>
            <source>lasting error (CUSUM)</source>
            <translation>지속적인 작은 오차 (CUSUM)</translation>
        </message>
        <message>
            <source>lasting error (EWMA)</source>
            <translation>지속적인 작은 오차 (EWMA)</translation>
        </message>
        <message>
            <source>No stored tuning of this job is left out.</source>
            <translation>이 작업에서 제외된 저장된 튜닝이 없습니다.</translation>
        </message>
        <message>
            <source>This job began from no stored tuning.</source>
            <translation>이 작업은 저장된 튜닝에서 시작하지 않았습니다.</translation>
        </message>
        <message>
            <source>angle_rev means %1 rpm; at least %2 rpm are expected: is the time in ms?</source>
            <translation>angle_rev이면 %1 rpm입니다. 최소 %2 rpm이어야 합니다. 시간이 ms입니까?</translation>
        </message>
        <message>
            <source>A tool comes to the end of its life</source>
            <translation>공구 수명이 거의 끝났습니다</translation>
        </message>
        <message>
            <source>Cutting force unknown: control would go no faster than planned.</source>
            <translation>절삭력을 모름: 제어한다면 계획보다 빠르지 않게 합니다.</translation>
        </message>
        <message>
            <source>Feed really made is unknown: control would go no faster than planned.</source>
            <translation>실제 이송을 모름: 제어한다면 계획보다 빠르지 않게 합니다.</translation>
        </message>
        <message>
            <source>Have the next tool ready. After the change touch the strip under the header, and New tool.</source>
            <translation>다음 공구를 준비하십시오. 교환한 뒤 머리글 아래 띠를 누르고 ‘새 공구’를 누르십시오.</translation>
        </message>
        <message>
            <source>In air: control would take the entry feed until the tool meets the work.</source>
            <translation>공중: 제어한다면 공구가 닿을 때까지 진입 이송을 씁니다.</translation>
        </message>
        <message>
            <source>It has made nine tenths of the parts that were set for it, or more.</source>
            <translation>정해 둔 수명의 9할 이상을 가공했습니다.</translation>
        </message>
        <message>
            <source>Nothing is stopped. Wear beyond its life changes the parts, and the loop has to follow it.</source>
            <translation>멈추지는 않습니다. 수명을 넘긴 마모는 공작물을 바꾸며, 제어가 이를 따라가야 합니다.</translation>
        </message>
        <message>
            <source>Outside the training range: the shift would fade to hold. Measure the origin.</source>
            <translation>학습 범위 밖: 제어한다면 보정을 서서히 멈춥니다. 원점을 측정하십시오.</translation>
        </message>
        <message>
            <source>Programmed feed unknown: control would go no faster than the schedule's lowest feed.</source>
            <translation>프로그램 이송을 모름: 제어한다면 계획의 최저 이송을 넘지 않음.</translation>
        </message>
        <message>
            <source>Ready: force feedback would begin at the touch of the next part.</source>
            <translation>준비됨: 제어한다면 다음 공작물에 닿을 때 힘 피드백을 시작합니다.</translation>
        </message>
        <message>
            <source>Spindle overhang unknown: control would go no faster than the schedule's lowest feed.</source>
            <translation>주축 돌출 길이를 모름: 제어한다면 계획의 최저 이송을 넘지 않음.</translation>
        </message>
        <message>
            <source>Spindle speed unknown or zero: control would go no faster than the schedule's lowest feed.</source>
            <translation>주축 회전수를 모르거나 0: 제어한다면 계획의 최저 이송을 넘지 않음.</translation>
        </message>
        <message>
            <source>The best feed lies outside %1 to %2 mm/rev: the feed would sit at the limit.</source>
            <translation>최적 이송이 %1~%2 mm/rev 범위 밖: 제어한다면 이송이 한계에 머무름.</translation>
        </message>
        <message>
            <source>The feed stands; control would go on with it.</source>
            <translation>이송이 멈춤: 제어한다면 그대로 이어 갑니다.</translation>
        </message>
        <message>
            <source>The feed would follow the schedule along the bore.</source>
            <translation>제어한다면 내경을 따라 이송이 계획대로 움직입니다.</translation>
        </message>
        <message>
            <source>The feed would hold the reference force.</source>
            <translation>제어한다면 이송이 기준 절삭력을 유지합니다.</translation>
        </message>
        <message>
            <source>The insert of the boring bar has made %1 of %2 parts.</source>
            <translation>보링 바 인서트: %2개 중 %1개 가공.</translation>
        </message>
        <message>
            <source>The milling tool has made %1 of %2 parts.</source>
            <translation>밀링 공구: %2개 중 %1개 가공.</translation>
        </message>
        <message>
            <source>The reference force would need a feed outside %1 to %2 mm/s.</source>
            <translation>기준 절삭력에 맞추려면 %1~%2 mm/s 범위 밖의 이송이 필요합니다.</translation>
        </message>
        <message>
            <source>The shift would sit at its limit of size or rate.</source>
            <translation>제어한다면 보정량이 크기나 속도 한계에 머무릅니다.</translation>
        </message>
        <message>
            <source>The tap has cut %1 of %2 threads.</source>
            <translation>탭: 나사 %2개 중 %1개 가공.</translation>
        </message>
        <message>
            <source>The trim would cancel %1 tones of the disturbance.</source>
            <translation>제어한다면 보정이 외란의 톤 %1개를 상쇄합니다.</translation>
        </message>
        <message>
            <source>The trim would follow the depth error.</source>
            <translation>제어한다면 보정이 깊이 오차를 따라갑니다.</translation>
        </message>
        <message>
            <source>The trim would follow what can be foreseen of the disturbance.</source>
            <translation>제어한다면 보정이 예측 가능한 외란을 따라갑니다.</translation>
        </message>
        <message>
            <source>The turning tool has made %1 of %2 parts.</source>
            <translation>선삭 공구: %2개 중 %1개 가공.</translation>
        </message>
        <message>
            <source>The work origin would follow the predicted drift.</source>
            <translation>제어한다면 공작물 원점이 예측한 열변위를 따라갑니다.</translation>
        </message>
        <message>
            <source>A command was not carried out</source>
            <translation>명령이 실행되지 않았습니다</translation>
        </message>
        <message>
            <source>Accept a feed schedule</source>
            <translation>이송 계획 승인</translation>
        </message>
        <message>
            <source>Add a part type for boring</source>
            <translation>보링 품종 추가</translation>
        </message>
        <message>
            <source>Announce a change of tool or material</source>
            <translation>공구 또는 소재 변경 알림</translation>
        </message>
        <message>
            <source>Change a boring recipe</source>
            <translation>보링 레시피 변경</translation>
        </message>
        <message>
            <source>Change law or reference of milling</source>
            <translation>밀링 법칙 또는 기준값 변경</translation>
        </message>
        <message>
            <source>Change the blank profile</source>
            <translation>소재 형상 변경</translation>
        </message>
        <message>
            <source>Change the law of turning</source>
            <translation>선삭 법칙 변경</translation>
        </message>
        <message>
            <source>Change the limits of the thermal shift</source>
            <translation>열 시프트 한계 변경</translation>
        </message>
        <message>
            <source>Change the milling setup</source>
            <translation>밀링 설정 변경</translation>
        </message>
        <message>
            <source>Change the turning setup</source>
            <translation>선삭 설정 변경</translation>
        </message>
        <message>
            <source>Choose a milled part type</source>
            <translation>밀링 품종 선택</translation>
        </message>
        <message>
            <source>Close a lot or leave it out of memory</source>
            <translation>로트 마감 또는 기억에서 제외</translation>
        </message>
        <message>
            <source>Close the port in the firewall and give it passwords of your own: see the LinuxCNC guide, "Close the port". Then start the console anew.</source>
            <translation>방화벽에서 포트를 닫고 고유한 암호를 설정하십시오. LinuxCNC 안내서의 "Close the port"를 참조하십시오. 그런 다음 콘솔을 다시 시작하십시오.</translation>
        </message>
        <message>
            <source>Correct or void a diameter</source>
            <translation>지름 정정 또는 무효 처리</translation>
        </message>
        <message>
            <source>Enter a diameter</source>
            <translation>지름 입력</translation>
        </message>
        <message>
            <source>Give a reason: it is kept with the change.</source>
            <translation>사유를 입력하십시오. 변경과 함께 보관됩니다.</translation>
        </message>
        <message>
            <source>It answers on %1.</source>
            <translation>%1에서 응답합니다.</translation>
        </message>
        <message>
            <source>Leave a milling tool out of memory</source>
            <translation>밀링 공구를 기억에서 제외</translation>
        </message>
        <message>
            <source>Leave a stored tuning out</source>
            <translation>저장된 튜닝 제외</translation>
        </message>
        <message>
            <source>Load a tapping job</source>
            <translation>태핑 작업 불러오기</translation>
        </message>
        <message>
            <source>Network, server or sign-on: the Diagnostics page says what it answered last.</source>
            <translation>네트워크, 서버 또는 로그인 문제입니다. 마지막 응답은 진단 페이지에 있습니다.</translation>
        </message>
        <message>
            <source>Nothing is lost: parts and values wait here and travel when it answers again.</source>
            <translation>잃어버린 것은 없습니다. 공작물과 값은 여기서 기다렸다가 서버가 다시 응답하면 전송됩니다.</translation>
        </message>
        <message>
            <source>Nothing to do at the machine. Tell whoever looks after the server when it stays.</source>
            <translation>기계에서 할 일은 없습니다. 계속되면 서버 담당자에게 알리십시오.</translation>
        </message>
        <message>
            <source>Open or choose a lot</source>
            <translation>로트 열기 또는 선택</translation>
        </message>
        <message>
            <source>Overhangs from %1 to %2 mm lie beyond what Z reaches by the machine file.</source>
            <translation>돌출 길이 %1 ~ %2 mm는 기계 파일의 Z 이동 범위를 벗어납니다.</translation>
        </message>
        <message>
            <source>Place a sensor on the picture</source>
            <translation>그림에 센서 위치 지정</translation>
        </message>
        <message>
            <source>Put a thermal model live or back</source>
            <translation>열 모델 적용 또는 되돌리기</translation>
        </message>
        <message>
            <source>Raise a limit of milling</source>
            <translation>밀링 한계 올리기</translation>
        </message>
        <message>
            <source>Raise a limit of turning</source>
            <translation>선삭 한계 올리기</translation>
        </message>
        <message>
            <source>Read the reason beside it, look at the control's own message, put it right and ask again.</source>
            <translation>옆의 사유와 제어기 자체 메시지를 확인하고, 바로잡은 뒤 다시 요청하십시오.</translation>
        </message>
        <message>
            <source>Record a gap-sensor session</source>
            <translation>갭 센서 측정 기록</translation>
        </message>
        <message>
            <source>Release a stop</source>
            <translation>정지 해제</translation>
        </message>
        <message>
            <source>Say that a new milling tool is in</source>
            <translation>새 밀링 공구 장착 알림</translation>
        </message>
        <message>
            <source>Switch a loop</source>
            <translation>루프 전환</translation>
        </message>
        <message>
            <source>Take a reference or a measurement of the origin over</source>
            <translation>원점의 기준 설정 또는 측정값 적용</translation>
        </message>
        <message>
            <source>The control or a rule of Kerf's has refused it, or nothing came of it.</source>
            <translation>제어기 또는 Kerf의 규칙이 거부했거나 아무 일도 일어나지 않았습니다.</translation>
        </message>
        <message>
            <source>The control's command port is open to the network</source>
            <translation>제어기의 명령 포트가 네트워크에 열려 있습니다</translation>
        </message>
        <message>
            <source>The machine file does not name this process under hosts.</source>
            <translation>기계 파일의 hosts에 이 공정이 없습니다.</translation>
        </message>
        <message>
            <source>The program is %1 mm long; the machine file gives this axis %2 mm.</source>
            <translation>프로그램 길이는 %1 mm인데 기계 파일의 이 축 이동 거리는 %2 mm입니다.</translation>
        </message>
        <message>
            <source>The program wants %1 rpm; the machine file allows the spindle %2 rpm.</source>
            <translation>프로그램은 %1 rpm을 요구하지만 기계 파일의 주축 허용값은 %2 rpm입니다.</translation>
        </message>
        <message>
            <source>The shop's store is out of reach</source>
            <translation>공장 저장소에 연결할 수 없습니다</translation>
        </message>
        <message>
            <source>Tune, accept a tuning or roll it back</source>
            <translation>튜닝, 튜닝 승인 또는 되돌리기</translation>
        </message>
        <message>
            <source>What was asked for has not happened. The machine stands as it stood before.</source>
            <translation>요청한 일은 일어나지 않았습니다. 기계는 이전 상태 그대로입니다.</translation>
        </message>
        <message>
            <source>Whoever reaches this computer may move the machine.</source>
            <translation>이 컴퓨터에 접근하는 누구나 기계를 움직일 수 있습니다.</translation>
        </message>
        <message>
            <source>linuxcncrsh answers on an address that other computers reach, with passwords that everybody knows.</source>
            <translation>linuxcncrsh가 다른 컴퓨터에서 접근할 수 있는 주소에서, 누구나 아는 암호로 응답합니다.</translation>
        </message>
        <message>
            <source>units: the machine file says %1, [TRAJ]LINEAR_UNITS of the control says %2. Nothing is commanded before they agree.</source>
            <translation>units: 기계 파일은 %1, 제어기의 [TRAJ]LINEAR_UNITS는 %2입니다. 일치할 때까지 아무 명령도 보내지 않습니다.</translation>
        </message>
        <message>
            <source>Reason of a stop, note or handover of a shift</source>
            <translation>정지 사유, 메모 또는 교대 인수인계</translation>
        </message>
        <message>
            <source>Say that a new tool is in</source>
            <translation>새 공구 장착 알림</translation>
        </message>
        <message>
            <source>Set the life of a tool</source>
            <translation>공구 수명 설정</translation>
        </message>
        <message>
            <source>A backup has taken the place of the data; what was there is kept as %1.</source>
            <translation>백업이 데이터를 대신했습니다. 이전 데이터는 %1에 보관했습니다.</translation>
        </message>
        <message>
            <source>A backup lies ready, but not who has asked for it: delete kerf.db.restore or ask again.</source>
            <translation>백업은 준비되었지만 요청한 사람을 알 수 없습니다. kerf.db.restore를 지우거나 다시 요청하십시오.</translation>
        </message>
        <message>
            <source>Nobody takes himself off the list: somebody else has to.</source>
            <translation>자기 자신은 목록에서 뺄 수 없습니다. 다른 사람이 해야 합니다.</translation>
        </message>
        <message>
            <source>Put a backup in the place of the data</source>
            <translation>백업으로 데이터 바꾸기</translation>
        </message>
        <message>
            <source>Take somebody off the list of people</source>
            <translation>사람을 목록에서 빼기</translation>
        </message>
        <message>
            <source>The backup could not be put in place: check the folder and its permissions.</source>
            <translation>백업을 제자리에 놓지 못했습니다. 폴더와 권한을 확인하십시오.</translation>
        </message>
        <message>
            <source>There is no such file.</source>
            <translation>그런 파일이 없습니다.</translation>
        </message>
        <message>
            <source>There is no such person on the list.</source>
            <translation>목록에 그런 사람이 없습니다.</translation>
        </message>
        <message>
            <source>This backup is of a later version of Kerf.</source>
            <translation>이 백업은 더 새로운 Kerf의 것입니다.</translation>
        </message>
        <message>
            <source>This is no data file of Kerf's.</source>
            <translation>Kerf의 데이터 파일이 아닙니다.</translation>
        </message>
        <message>
            <source>Change the spindle speed by 5 to 15 %, take less depth, or clamp tool and work shorter.</source>
            <translation>주축 회전수를 5~15 % 바꾸거나, 절입 깊이를 줄이거나, 공구와 공작물을 더 짧게 고정하세요.</translation>
        </message>
        <message>
            <source>Chatter</source>
            <translation>채터 진동</translation>
        </message>
        <message>
            <source>The force swings at a frequency that is no multiple of the spindle's: at this depth and speed the cut excites tool and work.</source>
            <translation>절삭력이 주축 회전수의 배수가 아닌 주파수로 흔들립니다. 이 절입 깊이와 회전수에서 절삭이 공구와 공작물을 가진합니다.</translation>
        </message>
        <message>
            <source>The force swings by %1 N at about %2 Hz.</source>
            <translation>절삭력이 약 %2 Hz로 %1 N만큼 흔들립니다.</translation>
        </message>
        <message>
            <source>The wall gets marks, the tool wears fast and may break. The feed goes on holding the mean force: it does not cure chatter.</source>
            <translation>가공면에 자국이 남고 공구가 빨리 마모되며 파손될 수 있습니다. 이송은 계속 평균 절삭력을 유지하지만 채터 진동을 없애지는 못합니다.</translation>
        </message>
        <message>
            <source>Raise a limit by more than half, with a second person</source>
            <translation>두 번째 사람과 함께 한계를 절반 넘게 올리기</translation>
        </message>
        <message>
            <source>Raising a limit by more than half takes two: another setter or process engineer says yes first (touch the name in the header, Second person).</source>
            <translation>한계를 절반 넘게 올리려면 두 사람이 필요합니다. 다른 셋업 담당자나 공정 엔지니어가 먼저 승인해야 합니다(위쪽의 이름을 누르고 두 번째 사람).</translation>
        </message>
        <message>
            <source>A deviation of more than 200 µm is no thermal drift: look at the part.</source>
            <translation>200 µm를 넘는 편차는 열변위가 아닙니다. 공작물을 확인하십시오.</translation>
        </message>
        <message>
            <source>A part is being cut: the shift waits for its end.</source>
            <translation>공작물을 가공 중입니다. 보정은 끝날 때까지 기다립니다.</translation>
        </message>
        <message>
            <source>Diameter (X), measured − nominal</source>
            <translation>지름(X), 측정값 − 공칭값</translation>
        </message>
        <message>
            <source>Length (Z), measured − nominal</source>
            <translation>길이(Z), 측정값 − 공칭값</translation>
        </message>
        <message>
            <source>No part has been finished since the reference that has not been measured yet.</source>
            <translation>기준 이후 완성되어 아직 측정하지 않은 공작물이 없습니다.</translation>
        </message>
        <message>
            <source>Nothing of the part has been measured.</source>
            <translation>공작물에서 측정한 값이 없습니다.</translation>
        </message>
        <message>
            <source>The model has changed since that part was cut: measure the next one.</source>
            <translation>그 공작물을 가공한 뒤 모델이 바뀌었습니다. 다음 공작물을 측정하십시오.</translation>
        </message>
        <message>
            <source>Y, measured − nominal</source>
            <translation>Y, 측정값 − 공칭값</translation>
        </message>
        <message>
            <source>At %1 rpm this force signal brings %2 values per revolution; 8 are needed.</source>
            <translation>%1 rpm에서 이 힘 신호는 회전당 값이 %2개입니다. 8개가 필요합니다.</translation>
        </message>
        <message>
            <source>Behind the last cut the sensor's zero was not where it was before.</source>
            <translation>지난 절삭 뒤 센서의 영점이 전과 다릅니다.</translation>
        </message>
        <message>
            <source>Check cable and insulation of the sensor: moisture lets its charge leak.</source>
            <translation>센서의 케이블과 절연을 점검하십시오. 습기가 있으면 전하가 샙니다.</translation>
        </message>
        <message>
            <source>Force feedback needs a force of %1 Hz bandwidth; this one has %2 Hz: no trim.</source>
            <translation>힘 피드백에는 대역폭 %1 Hz의 힘 신호가 필요합니다. 이 신호는 %2 Hz이므로 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>In air: the zero of the force is taken.</source>
            <translation>공중: 힘의 영점을 잡습니다.</translation>
        </message>
        <message>
            <source>It may be wrong by %1 N.</source>
            <translation>%1 N까지 틀릴 수 있습니다.</translation>
        </message>
        <message>
            <source>Let the path begin in the air. If it comes back in a long cut: check the sensor's insulation, or divide the cut.</source>
            <translation>경로를 공중에서 시작하십시오. 긴 절삭에서 되풀이되면 센서의 절연을 점검하거나 절삭을 나누십시오.</translation>
        </message>
        <message>
            <source>Let the tool stand in the air before it touches. If it comes back in a long cut: check the sensor's insulation, or divide the cut.</source>
            <translation>공구가 닿기 전에 공중에 두십시오. 긴 절삭에서 되풀이되면 센서의 절연을 점검하거나 절삭을 나누십시오.</translation>
        </message>
        <message>
            <source>The bandwidth of the force signal is not stated: set kerf.force-bandwidth, or force.bandwidth_hz in the machine file.</source>
            <translation>힘 신호의 대역폭이 없습니다. kerf.force-bandwidth 또는 기계 파일의 force.bandwidth_hz를 설정하십시오.</translation>
        </message>
        <message>
            <source>The force counts as unknown: the feed stays, or falls to the planned feed if it was faster. Overload and breakage are not noticed.</source>
            <translation>힘을 모르는 것으로 봅니다. 이송은 그대로이거나, 더 빨랐으면 계획 이송으로 내려갑니다. 과부하와 파손은 알아채지 못합니다.</translation>
        </message>
        <message>
            <source>The force of that cut was wrong by as much at its end. The next cut trusts the zero for a shorter time.</source>
            <translation>그 절삭의 힘은 끝에서 그만큼 틀렸습니다. 다음 절삭은 영점을 더 짧게 믿습니다.</translation>
        </message>
        <message>
            <source>The force sensor does not keep its zero, and it was not taken before this cut, or is too old for its drift.</source>
            <translation>힘 센서가 영점을 유지하지 못하는데, 이 절삭 전에 영점을 잡지 못했거나 드리프트에 비해 너무 오래되었습니다.</translation>
        </message>
        <message>
            <source>The tool was not in the air for long enough before the cut.</source>
            <translation>절삭 전에 공구가 공중에 충분히 오래 있지 않았습니다.</translation>
        </message>
        <message>
            <source>The zero has moved by %1 N in the last cut.</source>
            <translation>지난 절삭에서 영점이 %1 N 이동했습니다.</translation>
        </message>
        <message>
            <source>The zero of the force has drifted</source>
            <translation>힘의 영점이 이동함</translation>
        </message>
        <message>
            <source>The zero of the force may have drifted: no trim in the rest of this part.</source>
            <translation>힘의 영점이 이동했을 수 있어 이 공작물의 나머지는 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>There is no trim in this part, or in the rest of it.</source>
            <translation>이 공작물, 또는 그 나머지에서 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>Zero of the force unknown</source>
            <translation>힘의 영점을 알 수 없음</translation>
        </message>
        <message>
            <source>kerf.force is linked, but sampler.0.pin.6 is not linked to the same signal: take kerf.hal of this version and kerf-force.hal.</source>
            <translation>kerf.force는 연결되었지만 sampler.0.pin.6이 같은 신호에 연결되지 않았습니다. 이 버전의 kerf.hal과 kerf-force.hal을 쓰십시오.</translation>
        </message>
        <message>
            <source>kerf.force-reset is not linked: the amplifier is not reset by Kerf.</source>
            <translation>kerf.force-reset이 연결되지 않아 Kerf가 증폭기를 리셋하지 않습니다.</translation>
        </message>
        <message>
            <source>A value from a file needs the file's name.</source>
            <translation>파일의 값에는 파일 이름이 필요합니다.</translation>
        </message>
        <message>
            <source>Change the register of gauges</source>
            <translation>게이지 대장 변경</translation>
        </message>
        <message>
            <source>Keep the study of a gauge</source>
            <translation>게이지 평가 저장</translation>
        </message>
        <message>
            <source>Part %1 has %2 mm here already; correct that one instead.</source>
            <translation>공작물 %1의 이 위치에는 이미 %2 mm가 있습니다. 그 값을 정정하십시오.</translation>
        </message>
        <message>
            <source>Part %1 is not in this lot.</source>
            <translation>공작물 %1은(는) 이 로트에 없습니다.</translation>
        </message>
        <message>
            <source>Part %1 is not measured at %2 mm.</source>
            <translation>공작물 %1은(는) %2 mm에서 측정하지 않습니다.</translation>
        </message>
        <message>
            <source>Part %1 stands in the file twice, with %2 mm and %3 mm.</source>
            <translation>공작물 %1이(가) 파일에 두 번 있습니다: %2 mm와 %3 mm.</translation>
        </message>
        <message>
            <source>Say what was done with a part out of tolerance</source>
            <translation>공차를 벗어난 공작물의 처리 기록</translation>
        </message>
        <message>
            <source>Set the limits of figures</source>
            <translation>지표의 한계 설정</translation>
        </message>
        <message>
            <source>Set where Q-DAS files appear</source>
            <translation>Q-DAS 파일 위치 설정</translation>
        </message>
        <message>
            <source>The data file numbers its measurements with gaps.</source>
            <translation>데이터 파일의 측정값 번호가 이어지지 않습니다.</translation>
        </message>
        <message>
            <source>The file holds no diameter that is not stored already.</source>
            <translation>파일에 아직 저장되지 않은 지름이 없습니다.</translation>
        </message>
        <message>
            <source>The file says nowhere at which depth this is: a column overhang_mm is missing.</source>
            <translation>파일에 어느 깊이인지 나와 있지 않습니다: overhang_mm 열이 없습니다.</translation>
        </message>
        <message>
            <source>This console takes no files of diameters.</source>
            <translation>이 콘솔은 지름 파일을 받지 않습니다.</translation>
        </message>
        <message>
            <source>%1 lots one after the other, %2 parts on the charts, %3 signals.</source>
            <translation>로트 %1개를 이어서: 관리도에 공작물 %2개, 신호 %3개.</translation>
        </message>
        <message>
            <source>Choose one lot: a report and its files are of one.</source>
            <translation>로트 하나를 고르십시오: 보고서와 파일은 로트 하나에 대한 것입니다.</translation>
        </message>
        <message>
            <source>The lots have no parts yet.</source>
            <translation>로트에 아직 공작물이 없습니다.</translation>
        </message>
        <message>
            <source>kerf.loss-scale is not linked: a bridge that comes late would leave the highest feed. Take kerf.hal of this version.</source>
            <translation>kerf.loss-scale이 연결되어 있지 않습니다. 브리지가 늦으면 가장 높은 이송이 남게 됩니다. 이 버전의 kerf.hal을 사용하십시오.</translation>
        </message>
        <message>
            <source>Draw on other machines' lots in the shop (1 yes, 0 no)</source>
            <translation>공장의 다른 기계 로트도 참고 (1 예, 0 아니요)</translation>
        </message>
        <message>
            <source>Expected from %1 earlier lots and %2 of other machines; the bending of a new tool differs by ± %3 % (1σ).</source>
            <translation>이전 로트 %1개와 다른 기계의 로트 %2개에서 예상합니다. 새 공구의 휨은 ± %3 % (1σ) 차이 납니다.</translation>
        </message>
        <message>
            <source>Expected from this lot, %1 earlier ones and %2 of other machines; after such a change the bending differs by ± %3 % (1σ).</source>
            <translation>이 로트와 이전 로트 %1개, 다른 기계의 로트 %2개에서 예상합니다. 이런 변경 뒤의 휨은 ± %3 % (1σ) 차이 납니다.</translation>
        </message>
        <message>
            <source>The connection in shop/memory cannot be used (no password may stand there): this lot begins without other machines' lots.</source>
            <translation>shop/memory의 연결을 쓸 수 없습니다(암호를 적으면 안 됩니다). 이 로트는 다른 기계의 로트 없이 시작합니다.</translation>
        </message>
        <message>
            <source>The data folder names no shop to read (shop/memory): this lot begins without other machines' lots.</source>
            <translation>데이터 폴더에 읽을 공장 서버가 적혀 있지 않습니다(shop/memory). 이 로트는 다른 기계의 로트 없이 시작합니다.</translation>
        </message>
        <message>
            <source>The shop answered after the first part had begun: this lot begins without other machines' lots.</source>
            <translation>첫 공작물이 시작된 뒤에 공장 서버가 응답했습니다. 이 로트는 다른 기계의 로트 없이 시작합니다.</translation>
        </message>
        <message>
            <source>The shop does not let this console read: this lot begins without other machines' lots.</source>
            <translation>공장 서버가 이 콘솔의 읽기를 허용하지 않습니다. 이 로트는 다른 기계의 로트 없이 시작합니다.</translation>
        </message>
        <message>
            <source>The shop has no lots of this part type on other machines.</source>
            <translation>공장 서버에 다른 기계의 이 품종 로트가 없습니다.</translation>
        </message>
        <message>
            <source>The shop is asked for lots of other machines.</source>
            <translation>공장 서버에 다른 기계의 로트를 묻고 있습니다.</translation>
        </message>
        <message>
            <source>The shop is out of reach: this lot begins without other machines' lots.</source>
            <translation>공장 서버에 연결할 수 없습니다. 이 로트는 다른 기계의 로트 없이 시작합니다.</translation>
        </message>
        <message>
            <source>There is no shop in the database: this lot begins without other machines' lots.</source>
            <translation>데이터베이스에 공장 자료가 없습니다. 이 로트는 다른 기계의 로트 없이 시작합니다.</translation>
        </message>
        <message>
            <source>Boring</source>
            <translation>보링</translation>
        </message>
        <message>
            <source>Change the set-up of a process</source>
            <translation>공정 설정 변경</translation>
        </message>
        <message>
            <source>Kerf does not know this process on a LinuxCNC.</source>
            <translation>Kerf는 LinuxCNC에서 이 공정을 알지 못합니다.</translation>
        </message>
        <message>
            <source>Milling</source>
            <translation>밀링</translation>
        </message>
        <message>
            <source>Tapping</source>
            <translation>탭 가공</translation>
        </message>
        <message>
            <source>The tool has made %1 of %2 parts.</source>
            <translation>공구: %2개 중 %1개 가공.</translation>
        </message>
        <message>
            <source>Thermal</source>
            <translation>열변위</translation>
        </message>
        <message>
            <source>Turning</source>
            <translation>선삭</translation>
        </message>
        <message>
            <source>Nobody commands this machine: the program that did has ended. This one only reads; end it and start it anew, then it commands.</source>
            <translation>이 기계를 지휘하는 프로그램이 없습니다. 지휘하던 프로그램은 끝났습니다. 이 프로그램은 읽기만 하므로 끝내고 다시 시작하면 지휘합니다.</translation>
        </message>
        <message>
            <source>The log file (-wal) beside the data file was deleted, moved or replaced while Kerf runs: nothing more is stored. End Kerf and start it anew; what waits is kept beside it.</source>
            <translation>Kerf 실행 중에 데이터 파일 옆의 로그 파일(-wal)이 삭제·이동되거나 바뀌었습니다. 더 이상 저장되지 않습니다. Kerf를 끝내고 다시 시작하십시오. 기다리는 항목은 그 옆에 보관됩니다.</translation>
        </message>
        <message>
            <source>full</source>
            <translation>수량 완료</translation>
        </message>
        <message>
            <source>kept by a version that noted no hash</source>
            <translation>해시를 기록하지 않던 버전이 남긴 항목</translation>
        </message>
        <message>
            <source>part type created</source>
            <translation>품종 등록</translation>
        </message>
        <message>
            <source>repeatability of gauge %1, study %2</source>
            <translation>게이지 %1의 반복성, 평가 %2</translation>
        </message>
        <message>
            <source>setup changed</source>
            <translation>설정 변경</translation>
        </message>
        <message>
            <source>%1 revisions of the recipe of %2 were saved, %3 are stored.</source>
            <translation>%2의 레시피 개정은 %1개 저장되었으나 들어 있는 것은 %3개입니다.</translation>
        </message>
        <message>
            <source>Nothing is stored here.</source>
            <translation>여기에는 저장된 것이 없습니다.</translation>
        </message>
        <message>
            <source>This recipe revision is of another version, or cannot be used.</source>
            <translation>이 레시피 개정은 다른 버전의 것이거나 쓸 수 없는 것입니다.</translation>
        </message>
        <message>
            <source>This revision leaves a tuning out or takes it in; it has no settings of its own.</source>
            <translation>이 개정은 튜닝을 제외하거나 다시 넣는 것이어서 자체 설정이 없습니다.</translation>
        </message>
        <message>
            <source>The backup %1 cannot be written: its folder is missing or read-only.</source>
            <translation>백업 %1을(를) 쓸 수 없습니다: 폴더가 없거나 쓰기 금지입니다.</translation>
        </message>
        <message>
            <source>Samples of the force are missing: no trim in the rest of this part.</source>
            <translation>힘의 표본이 빠져 이 공작물의 나머지는 보정하지 않습니다.</translation>
        </message>
        <message>
            <source>The key %1 stands twice in one object; it is expected once.</source>
            <translation>키 %1이(가) 한 객체에 두 번 있습니다. 한 번만 있어야 합니다.</translation>
        </message>
        <message>
            <source>The position of the boring spindle is missing, old, not a number, or stands still while it feeds.</source>
            <translation>보링 주축의 위치가 없거나 오래되었거나 숫자가 아니거나, 이송 중인데도 멈춰 있습니다.</translation>
        </message>
        <message>
            <source>There is no part type yet whose recipe could hold limits.</source>
            <translation>한계를 저장할 레시피가 있는 품종이 아직 없습니다.</translation>
        </message>
        <message>
            <source>%1 lots were opened, %2 are stored.</source>
            <translation>로트 %1개가 열렸고 %2개가 저장되어 있습니다.</translation>
        </message>
        <message>
            <source>A lot needs a name.</source>
            <translation>로트에는 이름이 필요합니다.</translation>
        </message>
        <message>
            <source>Lot %1 (%2) differs from what was logged when it was opened or closed.</source>
            <translation>로트 %1(%2)이(가) 열거나 닫을 때 기록된 내용과 다릅니다.</translation>
        </message>
        <message>
            <source>Lot, recipe or schedule has changed since the start was asked: look, then start again.</source>
            <translation>시작을 요청한 뒤 로트, 레시피 또는 스케줄이 바뀌었습니다. 확인하고 다시 시작하십시오.</translation>
        </message>
        <message>
            <source>No lot is open.</source>
            <translation>열린 로트가 없습니다.</translation>
        </message>
        <message>
            <source>Part %1 differs from what was kept of it when it was made, or one before it is missing.</source>
            <translation>공작물 %1이(가) 가공할 때 저장된 내용과 다르거나 그 앞의 공작물이 없습니다.</translation>
        </message>
        <message>
            <source>The part type has changed: nothing was opened.</source>
            <translation>품종이 바뀌었습니다. 로트를 열지 않았습니다.</translation>
        </message>
        <message>
            <source>There is a lot of this name already.</source>
            <translation>같은 이름의 로트가 이미 있습니다.</translation>
        </message>
        <message>
            <source>This lot is of %1: choose that part type first.</source>
            <translation>이 로트는 %1 품종입니다. 먼저 그 품종을 선택하십시오.</translation>
        </message>
        <message>
            <source>lot selected</source>
            <translation>로트 선택</translation>
        </message>
        <message>
            <source>The log file (kerf.log) cannot be written: check the data folder and its permissions.</source>
            <translation>로그 파일(kerf.log)을 쓸 수 없습니다. 데이터 폴더와 그 권한을 확인하십시오.</translation>
        </message>
        <message>
            <source>The name of the data folder is not UTF-8: rename it, or choose another one with --data.</source>
            <translation>데이터 폴더 이름이 UTF-8이 아닙니다. 이름을 바꾸거나 --data로 다른 폴더를 고르십시오.</translation>
        </message>
        <message>
            <source>Acceleration feed-forward of Z</source>
            <translation>Z축 가속 선행</translation>
        </message>
        <message>
            <source>Follow gain of Z</source>
            <translation>Z축 추종 게인</translation>
        </message>
        <message>
            <source>Follow gain of the spindle</source>
            <translation>주축 추종 게인</translation>
        </message>
        <message>
            <source>Shift only between parts</source>
            <translation>공작물 사이에서만 보정</translation>
        </message>
        <message>
            <source>Speed feed-forward of Z</source>
            <translation>Z축 속도 선행</translation>
        </message>
        <message>
            <source>Blank profile</source>
            <translation>소재 형상</translation>
        </message>
        <message>
            <source>Law</source>
            <translation>법칙</translation>
        </message>
        <message>
            <source>blank profile of before</source>
            <translation>이전 소재 형상</translation>
        </message>
        <message>
            <source>changed while cutting</source>
            <translation>가공 중 변경</translation>
        </message>
        <message>
            <source>law chosen</source>
            <translation>법칙 선택</translation>
        </message>
        <message>
            <source>law of before</source>
            <translation>이전 법칙</translation>
        </message>
        <message>
            <source>typed</source>
            <translation>직접 입력</translation>
        </message>
        <message>
            <source>A part is being cut: leave parts out between two of them.</source>
            <translation>공작물을 가공하는 중입니다. 공작물을 빼는 일은 공작물과 공작물 사이에 하십시오.</translation>
        </message>
        <message>
            <source>Leave a turned part out of memory</source>
            <translation>선삭한 공작물을 기억에서 빼기</translation>
        </message>
        <message>
            <source>Too little is known to be sure of the tolerance: the feed aims at %1 mm, from where both limits are equally far by the law.</source>
            <translation>공차를 확신하기에는 아는 것이 너무 적습니다. 이송은 법칙으로 볼 때 두 한계가 똑같이 먼 %1 mm를 겨냥합니다.</translation>
        </message>
        <message>
            <source>One address is asked after the other.</source>
            <translation>주소는 하나씩 차례로 묻습니다.</translation>
        </message>
        <message>
            <source>That sensor file cannot be used.</source>
            <translation>그 센서 파일은 쓸 수 없습니다.</translation>
        </message>
        <message>
            <source>The sensor file %1 cannot be used: only what the machine itself brings is read. Sensors says why.</source>
            <translation>센서 파일 %1을(를) 쓸 수 없습니다. 기계가 직접 주는 값만 읽습니다. 이유는 센서 화면에 있습니다.</translation>
        </message>
        <message>
            <source>Blank height</source>
            <translation>소재 높이</translation>
        </message>
        <message>
            <source>Leave a day out of thermal training</source>
            <translation>열변위 학습에서 하루 제외</translation>
        </message>
        <message>
            <source>One of the days is left out of the training: take it in again first.</source>
            <translation>고른 날 가운데 학습에서 제외한 날이 있습니다. 먼저 다시 포함하십시오.</translation>
        </message>
        <message>
            <source>%1 is neither; expected true or false.</source>
            <translation>%1: 둘 다 아닙니다. true 또는 false여야 합니다.</translation>
        </message>
        <message>
            <source>%1 is no list; expected [ … ].</source>
            <translation>%1: 목록이 아닙니다. [ … ] 형태여야 합니다.</translation>
        </message>
        <message>
            <source>%1 is no object; expected {…} with keys.</source>
            <translation>%1: 객체가 아닙니다. 키가 있는 {…} 형태여야 합니다.</translation>
        </message>
        <message>
            <source>the file: %1 is no object; expected {…} with keys.</source>
            <translation>파일: %1: 객체가 아닙니다. 키가 있는 {…} 형태여야 합니다.</translation>
        </message>
        <message>
            <source>%1 is no text; expected a text that is not empty.</source>
            <translation>%1: 텍스트가 아닙니다. 비어 있지 않은 텍스트여야 합니다.</translation>
        </message>
        <message>
            <source>%1 is no text; expected a text.</source>
            <translation>%1: 텍스트가 아닙니다. 텍스트여야 합니다.</translation>
        </message>
        <message>
            <source>%1 is out of range; expected a number from %2 to %3.</source>
            <translation>%1: 범위를 벗어났습니다. %2부터 %3까지의 수여야 합니다.</translation>
        </message>
        <message>
            <source>%1 is out of range; expected a whole number from %2 to %3.</source>
            <translation>%1: 범위를 벗어났습니다. %2부터 %3까지의 정수여야 합니다.</translation>
        </message>
        <message>
            <source>%1 is the device of %2 too; expected one of its own (the channels of a multiplexer belong to one gauge).</source>
            <translation>%1: %2의 장치이기도 합니다. 게이지마다 장치가 따로 있어야 합니다(멀티플렉서의 채널은 한 게이지에 속합니다).</translation>
        </message>
        <message>
            <source>%1 is the unit of modules[%2] on the same line; expected another one.</source>
            <translation>%1: 같은 회선에 있는 modules[%2]의 유닛 번호입니다. 다른 번호여야 합니다.</translation>
        </message>
        <message>
            <source>%1 of them; expected %2 at the most.</source>
            <translation>%1개입니다. 최대 %2개까지 됩니다.</translation>
        </message>
        <message>
            <source>%1 temperatures; expected %2 at the most.</source>
            <translation>온도가 %1개입니다. 최대 %2개까지 됩니다.</translation>
        </message>
        <message>
            <source>'%1' is no name; expected 1 to %2 bytes without comma, quote or line end.</source>
            <translation>'%1': 이름으로 쓸 수 없습니다. 쉼표, 따옴표, 줄 바꿈 없이 1~%2바이트여야 합니다.</translation>
        </message>
        <message>
            <source>'%1' is no pin of kerf-hal for this quantity; expected kerf.temperature-0 to kerf.temperature-%2 for a temperature.</source>
            <translation>'%1': 이 양에 맞는 kerf-hal 핀이 아닙니다. 온도는 kerf.temperature-0부터 kerf.temperature-%2까지입니다.</translation>
        </message>
        <message>
            <source>'%1' is not known; expected one of %2.</source>
            <translation>'%1': 모르는 값입니다. 다음 가운데 하나여야 합니다: %2.</translation>
        </message>
        <message>
            <source>'%1' is not the unit of a %2; expected %3, which scale and offset bring the register to.</source>
            <translation>'%1': %2의 단위가 아닙니다. scale과 offset으로 레지스터 값을 %3 단위로 맞춰야 합니다.</translation>
        </message>
        <message>
            <source>'%1' is the name of %2 too; expected another one.</source>
            <translation>'%1': %2의 이름이기도 합니다. 다른 이름이어야 합니다.</translation>
        </message>
        <message>
            <source>'%1': it has no group; expected one around the value.</source>
            <translation>'%1': 그룹이 없습니다. 값을 감싸는 그룹이 하나 있어야 합니다.</translation>
        </message>
        <message>
            <source>'%1': it is no regular expression; expected one as ^.*?([+-][0-9.]+).*$.</source>
            <translation>'%1': 정규식이 아닙니다. ^.*?([+-][0-9.]+).*$와 같은 형태여야 합니다.</translation>
        </message>
        <message>
            <source>0 makes every reading the same; expected a factor other than 0.</source>
            <translation>0이면 모든 값이 같아집니다. 0이 아닌 계수여야 합니다.</translation>
        </message>
        <message>
            <source>a force is too fast for a polled module; it comes over the HAL pin kerf.force (docs/sensors.md). Expected temperature or speed.</source>
            <translation>힘은 주기적으로 읽는 모듈로는 너무 빠릅니다. HAL 핀 kerf.force로 들어옵니다(docs/sensors.md). 온도나 회전수여야 합니다.</translation>
        </message>
        <message>
            <source>the file: a number is too large to be stored; expected a sensor file.</source>
            <translation>파일: 저장할 수 없을 만큼 큰 수가 있습니다. 센서 파일이어야 합니다.</translation>
        </message>
        <message>
            <source>a second speed; expected one at the most.</source>
            <translation>두 번째 회전수입니다. 하나만 됩니다.</translation>
        </message>
        <message>
            <source>cannot be read, or is empty; expected a sensor file.</source>
            <translation>읽을 수 없거나 비어 있습니다. 센서 파일이어야 합니다.</translation>
        </message>
        <message>
            <source>it could not be asked; the log says why.</source>
            <translation>물어볼 수 없었습니다. 이유는 로그에 있습니다.</translation>
        </message>
        <message>
            <source>larger than %1 MB; expected a sensor file.</source>
            <translation>%1 MB보다 큽니다. 센서 파일이어야 합니다.</translation>
        </message>
        <message>
            <source>missing; expected a regular expression whose first group is the value.</source>
            <translation>빠져 있습니다. 첫 그룹이 값인 정규식이어야 합니다.</translation>
        </message>
        <message>
            <source>missing; expected a value.</source>
            <translation>빠져 있습니다. 값이 있어야 합니다.</translation>
        </message>
        <message>
            <source>modules[%1] is on the same line %2 with other settings; expected the same baud, parity and stop_bits.</source>
            <translation>modules[%1]이 같은 회선 %2에 다른 설정으로 있습니다. baud, parity, stop_bits가 같아야 합니다.</translation>
        </message>
        <message>
            <source>the file: more than %1 brackets inside each other; expected a sensor file.</source>
            <translation>파일: 괄호가 %1겹보다 깊습니다. 센서 파일이어야 합니다.</translation>
        </message>
        <message>
            <source>the file: more than %1 keys in one object; expected a sensor file.</source>
            <translation>파일: 한 객체에 키가 %1개보다 많습니다. 센서 파일이어야 합니다.</translation>
        </message>
        <message>
            <source>no value in it; expected at least one that means a fault.</source>
            <translation>값이 없습니다. 고장을 뜻하는 값이 하나 이상 있어야 합니다.</translation>
        </message>
        <message>
            <source>none; expected at least one channel or gauge.</source>
            <translation>하나도 없습니다. 채널이나 게이지가 하나 이상 있어야 합니다.</translation>
        </message>
        <message>
            <source>not an object; expected {"channel": depth, …}.</source>
            <translation>객체가 아닙니다. {"채널": 깊이, …} 형태여야 합니다.</translation>
        </message>
        <message>
            <source>only for the protocol pattern; expected no such key here.</source>
            <translation>프로토콜 pattern에만 쓰는 키입니다. 여기에는 없어야 합니다.</translation>
        </message>
        <message>
            <source>that is no address; expected HOST or HOST:PORT, PORT from 1 to 65535.</source>
            <translation>주소가 아닙니다. HOST 또는 HOST:PORT 형태이고 PORT는 1부터 65535까지입니다.</translation>
        </message>
        <message>
            <source>the key stands twice in one object; expected it once.</source>
            <translation>한 객체에 같은 키가 두 번 있습니다. 한 번만 있어야 합니다.</translation>
        </message>
        <message>
            <source>there is no module '%1'; expected the name of one in modules.</source>
            <translation>이런 모듈이 없습니다: '%1'. modules에 있는 이름이어야 합니다.</translation>
        </message>
        <message>
            <source>line %1, column %2: this is no JSON from here on; expected a complete JSON object.</source>
            <translation>%1행 %2열: 여기부터 JSON이 아닙니다. 완전한 JSON 객체여야 합니다.</translation>
        </message>
        <message>
            <source>unknown key %2; expected one of %1.</source>
            <translation>모르는 키입니다(%2). 다음 가운데 하나여야 합니다: %1.</translation>
        </message>
        <message>
            <source>accepted</source>
            <translation>수락됨</translation>
        </message>
        <message>
            <source>rolled back</source>
            <translation>되돌림</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ActionChart</name>
        <message>
            <source>part</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>feed in the middle of the bore</source>
            <translation>내경 중앙의 이송</translation>
        </message>
        <message>
            <source>What the controller does from part to part appears here.</source>
            <translation>제어기가 공작물마다 하는 일이 여기에 표시됩니다.</translation>
        </message>
        <message>
            <source>Control action</source>
            <translation>제어 동작</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::AlarmBar</name>
        <message>
            <source>No alarms.</source>
            <translation>알람이 없습니다.</translation>
        </message>
        <message numerus="yes">
            <source>%1  (and %n more)</source>
            <translation>
                <numerusform>%1  (외 %n건)</numerusform>
            </translation>
        </message>
        <message>
            <source>Show</source>
            <translation>보기</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::AlarmModel</name>
        <message>
            <source>stands, seen by %1</source>
            <translation>발생 중, %1 확인</translation>
        </message>
        <message>
            <source>stands</source>
            <translation>발생 중</translation>
        </message>
        <message>
            <source>stood at the last restart</source>
            <translation>지난 재시작 때 발생 중</translation>
        </message>
        <message>
            <source>gone %1, seen by %2</source>
            <translation>%1 해소, %2 확인</translation>
        </message>
        <message>
            <source>gone %1</source>
            <translation>%1 해소</translation>
        </message>
        <message>
            <source>%1, first</source>
            <translation>%1, 최초</translation>
        </message>
        <message>
            <source>Prio.</source>
            <translation>순위</translation>
        </message>
        <message>
            <source>Alarm</source>
            <translation>알람</translation>
        </message>
        <message>
            <source>Since</source>
            <translation>발생</translation>
        </message>
        <message>
            <source>State</source>
            <translation>상태</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::AlarmsPage</name>
        <message>
            <source>That is all.</source>
            <translation>이것이 전부입니다.</translation>
        </message>
        <message>
            <source>No database is connected: only the alarms since the start are known.</source>
            <translation>데이터베이스가 연결되지 않아 시작한 뒤의 알람만 알 수 있습니다.</translation>
        </message>
        <message>
            <source>No alarm has been recorded yet.</source>
            <translation>아직 기록된 알람이 없습니다.</translation>
        </message>
        <message>
            <source>No alarms stand. One that comes up appears here until it has gone and been seen.</source>
            <translation>발생 중인 알람이 없습니다. 알람이 생기면 해소되고 확인될 때까지 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Choose an alarm.</source>
            <translation>알람을 고르십시오.</translation>
        </message>
        <message>
            <source>Seen by %1.</source>
            <translation>%1 확인함.</translation>
        </message>
        <message>
            <source>It is from an earlier run.</source>
            <translation>이전 실행의 알람입니다.</translation>
        </message>
        <message>
            <source>Standing or unseen</source>
            <translation>발생 중·미확인</translation>
        </message>
        <message>
            <source>History</source>
            <translation>이력</translation>
        </message>
        <message>
            <source>Older</source>
            <translation>더 이전</translation>
        </message>
        <message>
            <source>Cause</source>
            <translation>원인</translation>
        </message>
        <message>
            <source>Consequence</source>
            <translation>영향</translation>
        </message>
        <message>
            <source>What to do</source>
            <translation>조치</translation>
        </message>
        <message>
            <source>Seen</source>
            <translation>확인</translation>
        </message>
        <message>
            <source>All priorities</source>
            <translation>모든 등급</translation>
        </message>
        <message>
            <source>Priority 1 and 2</source>
            <translation>1·2등급</translation>
        </message>
        <message>
            <source>Priority 1 only</source>
            <translation>1등급만</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>내보내기</translation>
        </message>
        <message>
            <source>Export the history</source>
            <translation>이력 내보내기</translation>
        </message>
        <message>
            <source>What the list shows, as CSV. A file that is there already is never written over.</source>
            <translation>목록에 보이는 것을 CSV로 저장합니다. 이미 있는 파일은 덮어쓰지 않습니다.</translation>
        </message>
        <message>
            <source>Written: %1</source>
            <translation>저장했습니다: %1</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::BoreChart</name>
        <message>
            <source>part</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>bore ⌀</source>
            <translation>내경 ⌀</translation>
        </message>
        <message>
            <source>The bore of each part appears here once its diameter is entered.</source>
            <translation>지름을 입력하면 공작물마다 내경이 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>upper</source>
            <translation>상한</translation>
        </message>
        <message>
            <source>lower</source>
            <translation>하한</translation>
        </message>
        <message>
            <source>Bore against its tolerance, last 25 parts</source>
            <translation>공차 대비 내경, 최근 25개</translation>
        </message>
        <message>
            <source>expected</source>
            <translation>예상</translation>
        </message>
        <message>
            <source>process changed</source>
            <translation>공정 변화</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::BoringPage</name>
        <message>
            <source>No boring lot is open on this machine. The page fills as soon as one is.</source>
            <translation>이 기계에 열린 보링 로트가 없습니다. 로트를 열면 이 화면이 채워집니다.</translation>
        </message>
        <message>
            <source>Bore ⌀, %1 – last 25 parts of lot %2</source>
            <comment>unit, lot</comment>
            <translation>내경 ⌀, %1 – 로트 %2의 최근 25개</translation>
        </message>
        <message>
            <source>Nothing can be stored at the moment: %1</source>
            <translation>지금은 저장할 수 없습니다: %1</translation>
        </message>
        <message>
            <source>%1 (corrected)</source>
            <translation>%1 (수정됨)</translation>
        </message>
        <message>
            <source>%1, expected %2 ± %3</source>
            <comment>diameter, prediction, half interval</comment>
            <translation>%1, 예상 %2 ± %3</translation>
        </message>
        <message>
            <source>Part %1: %2 %3.</source>
            <comment>number, diameters, unit</comment>
            <translation>%1번 공작물: %2 %3.</translation>
        </message>
        <message>
            <source>Diameters of this lot</source>
            <translation>이 로트의 지름</translation>
        </message>
        <message>
            <source>Touch a value to correct or take it out, an empty place to enter it.</source>
            <translation>값을 누르면 수정하거나 뺄 수 있고, 빈 곳을 누르면 입력합니다.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>Cpk %1 (%2)</source>
            <comment>figure, depth</comment>
            <translation>Cpk %1 (%2)</translation>
        </message>
        <message>
            <source>What is new with the next part?</source>
            <translation>다음 공작물에서 무엇이 바뀝니까?</translation>
        </message>
        <message>
            <source>The expected diameters then begin from what such changes have brought before. Nothing known: just go on.</source>
            <translation>그러면 예상 내경은 그런 변경이 지금까지 가져온 결과에서 시작합니다. 아는 것이 없으면 그냥 계속하십시오.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Take back</source>
            <translation>예고 취소</translation>
        </message>
        <message>
            <source>The gauge sent %1: it is taken when somebody signs on.</source>
            <translation>게이지가 %1 값을 보냈습니다. 누군가 로그인하면 받아들입니다.</translation>
        </message>
        <message>
            <source>The gauge sent %1 a while ago: left out, measure again.</source>
            <translation>게이지 값 %1: 시간이 지나 제외했습니다. 다시 측정하십시오.</translation>
        </message>
        <message>
            <source>Channel %1</source>
            <translation>채널 %1</translation>
        </message>
        <message>
            <source>Gauge %1 is overdue since %2: have it checked before you rely on it.</source>
            <translation>게이지 %1의 교정 기한이 %2에 지났습니다. 사용하기 전에 교정하십시오.</translation>
        </message>
        <message>
            <source>From a file</source>
            <translation>파일에서</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>게이지</translation>
        </message>
        <message>
            <source>Which gauge sends the readings: it is kept with each value. Which channel of a gauge's switch measures at which depth.</source>
            <translation>측정값을 보내는 게이지: 값마다 함께 저장됩니다. 게이지 전환기의 어느 채널이 어느 깊이를 측정하는지.</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>게이지</translation>
        </message>
        <message>
            <source>not said</source>
            <translation>지정 안 함</translation>
        </message>
        <message>
            <source>Gauge at hand</source>
            <translation>사용 중인 게이지</translation>
        </message>
        <message>
            <source>Learn the channels anew</source>
            <translation>채널 다시 학습</translation>
        </message>
        <message>
            <source>Which gauge is asked?</source>
            <translation>어느 게이지에서 읽습니까?</translation>
        </message>
        <message>
            <source>Touch the one that measures this bore.</source>
            <translation>이 내경을 재는 게이지를 누르십시오.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::Chart</name>
        <message>
            <source>%1, %2</source>
            <comment>axis title, unit</comment>
            <translation>%1, %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ComparisonPanel</name>
        <message>
            <source>no part is archived yet</source>
            <translation>아직 보관된 공작물이 없습니다</translation>
        </message>
        <message>
            <source>Without and with the loop</source>
            <translation>루프 없이와 루프로</translation>
        </message>
        <message>
            <source>Archive of parts</source>
            <translation>공작물 보관함</translation>
        </message>
        <message>
            <source>Cut one part in Advise and one in Control with the same setup: the comparison appears here after the second.</source>
            <translation>같은 설정으로 하나는 추천, 하나는 제어로 절삭하십시오. 두 번째가 끝나면 여기에 비교가 나타납니다.</translation>
        </message>
        <message>
            <source>second half</source>
            <translation>후반</translation>
        </message>
        <message>
            <source>part %1, open</source>
            <translation>공작물 %1, 개루프</translation>
        </message>
        <message>
            <source>part %1, %2</source>
            <comment>number, controller</comment>
            <translation>공작물 %1, %2</translation>
        </message>
        <message>
            <source>change</source>
            <translation>변화</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>RMS</translation>
        </message>
        <message>
            <source>P-V</source>
            <translation>P-V</translation>
        </message>
        <message>
            <source>mean force</source>
            <translation>평균 힘</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ContourChart</name>
        <message>
            <source>rev</source>
            <comment>spindle revolutions, on an axis</comment>
            <translation>회전</translation>
        </message>
        <message>
            <source>error</source>
            <translation>오차</translation>
        </message>
        <message>
            <source>The contour error of the first tap appears here as soon as it is made.</source>
            <translation>첫 탭을 하면 그 윤곽 오차가 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Contour error over the spindle's way, in and out</source>
            <translation>주축 경로에 따른 윤곽 오차, 진입과 후퇴</translation>
        </message>
        <message>
            <source>6H: %1 p-p</source>
            <translation>6H: %1 p-p</translation>
        </message>
        <message>
            <source>reversal</source>
            <translation>반전</translation>
        </message>
        <message>
            <source>touch: whole course</source>
            <translation>터치: 전체 경로</translation>
        </message>
        <message>
            <source>touch: the band alone</source>
            <translation>터치: 공차대만</translation>
        </message>
        <message>
            <source>first tap</source>
            <translation>첫 탭</translation>
        </message>
        <message>
            <source>last tap</source>
            <translation>마지막 탭</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::DiagnosticsPage</name>
        <message>
            <source>%1 (%2 %)</source>
            <translation>%1 (%2 %)</translation>
        </message>
        <message>
            <source>Real-time scheduling is granted: the cycle goes before all other work of this computer.</source>
            <translation>실시간 스케줄링이 허용되었습니다. 사이클이 이 컴퓨터의 다른 모든 일보다 먼저 돕니다.</translation>
        </message>
        <message>
            <source>Real-time scheduling is not granted: other programs can delay the cycle. Allow it with “rtprio” in /etc/security/limits.conf.</source>
            <translation>실시간 스케줄링이 허용되지 않아 다른 프로그램이 사이클을 늦출 수 있습니다. /etc/security/limits.conf의 “rtprio”로 허용하십시오.</translation>
        </message>
        <message>
            <source>up</source>
            <translation>연결됨</translation>
        </message>
        <message>
            <source>connecting</source>
            <translation>연결 중</translation>
        </message>
        <message>
            <source>down</source>
            <translation>끊김</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>Work in one cycle</source>
            <translation>한 사이클의 처리 시간</translation>
        </message>
        <message>
            <source>Start after the deadline</source>
            <translation>기한 뒤의 시작 지연</translation>
        </message>
        <message>
            <source>time per cycle; height: share of all cycles</source>
            <translation>사이클당 시간; 높이: 전체 사이클 중 비율</translation>
        </message>
        <message>
            <source>lateness; height: share of all cycles</source>
            <translation>지연; 높이: 전체 사이클 중 비율</translation>
        </message>
        <message>
            <source>Engine</source>
            <translation>엔진</translation>
        </message>
        <message>
            <source>Machine and versions</source>
            <translation>기계와 버전</translation>
        </message>
        <message>
            <source>Cycles</source>
            <translation>사이클</translation>
        </message>
        <message>
            <source>Overruns</source>
            <translation>시간 초과</translation>
        </message>
        <message>
            <source>Chart samples dropped</source>
            <translation>버린 차트 샘플</translation>
        </message>
        <message>
            <source>Machine time per second</source>
            <translation>초당 기계 시간</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>기계</translation>
        </message>
        <message>
            <source>Link</source>
            <translation>연결</translation>
        </message>
        <message>
            <source>Machine time</source>
            <translation>기계 시간</translation>
        </message>
        <message>
            <source>Versions</source>
            <translation>버전</translation>
        </message>
        <message>
            <source>no database</source>
            <translation>데이터베이스 없음</translation>
        </message>
        <message>
            <source>being written</source>
            <translation>쓰는 중</translation>
        </message>
        <message>
            <source>Back up all data</source>
            <translation>전체 데이터 백업</translation>
        </message>
        <message>
            <source>A checked copy in one file, made while everything goes on. Touch where it shall go.</source>
            <translation>작업을 멈추지 않고 검사된 사본을 파일 하나로 만듭니다. 저장할 곳을 누르십시오.</translation>
        </message>
        <message>
            <source>Backed up to %1</source>
            <translation>백업함: %1</translation>
        </message>
        <message>
            <source>Not backed up: %1</source>
            <translation>백업하지 못함: %1</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>%1 ms (%2 kHz)</source>
            <translation>%1 ms (%2 kHz)</translation>
        </message>
        <message>
            <source>Period of the cycle</source>
            <translation>주기</translation>
        </message>
        <message>
            <source>The simulation runs faster than time: it needs no real-time scheduling and asks for none.</source>
            <translation>시뮬레이션이 실제 시간보다 빠르게 돕니다. 실시간 스케줄링이 필요 없어 요청하지 않습니다.</translation>
        </message>
        <message>
            <source>none: this console keeps its data to itself</source>
            <translation>없음: 이 콘솔은 데이터를 자체 보관합니다</translation>
        </message>
        <message>
            <source>Shop</source>
            <translation>공장 서버</translation>
        </message>
        <message>
            <source>Restore a backup</source>
            <translation>백업 복원</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::EntryPanel</name>
        <message>
            <source>no part waits</source>
            <translation>측정 대기 공작물 없음</translation>
        </message>
        <message>
            <source>none fitted</source>
            <translation>장착 안 됨</translation>
        </message>
        <message>
            <source>nothing entered</source>
            <translation>입력 없음</translation>
        </message>
        <message>
            <source>Enter the bore</source>
            <translation>내경 입력</translation>
        </message>
        <message>
            <source>Gauge</source>
            <translation>게이지</translation>
        </message>
        <message>
            <source>Undo last</source>
            <translation>직전 입력 취소</translation>
        </message>
        <message>
            <source>Correct</source>
            <translation>수정</translation>
        </message>
        <message>
            <source>Measure again</source>
            <translation>다시 측정</translation>
        </message>
        <message>
            <source>⌀ of %1</source>
            <comment>part and depth</comment>
            <translation>%1의 ⌀</translation>
        </message>
        <message>
            <source>No part waits for a diameter</source>
            <translation>측정 대기 공작물이 없습니다</translation>
        </message>
        <message>
            <source>For %1 type all figures.</source>
            <translation>%1: 모든 자리를 입력하십시오.</translation>
        </message>
        <message>
            <source>Type the last two figures, or the whole diameter.</source>
            <translation>마지막 두 자리 또는 지름 전체를 입력하십시오.</translation>
        </message>
        <message>
            <source>The first part is not cut yet. Its diameters are asked for here.</source>
            <translation>첫 공작물을 아직 가공하지 않았습니다. 지름은 여기서 묻습니다.</translation>
        </message>
        <message>
            <source>All parts cut so far are measured.</source>
            <translation>지금까지 가공한 공작물은 모두 측정했습니다.</translation>
        </message>
        <message>
            <source>Please answer: measure again, or confirm the value.</source>
            <translation>답해 주십시오: 다시 측정하거나 값을 확인하십시오.</translation>
        </message>
        <message>
            <source>Nothing typed for %1: type its last two figures.</source>
            <translation>%1: 입력이 없습니다. 마지막 두 자리를 입력하십시오.</translation>
        </message>
        <message>
            <source>“%1” for %2 is one figure short: type the last two, or the whole diameter.</source>
            <translation>%2의 “%1”은(는) 한 자리가 모자랍니다. 마지막 두 자리 또는 지름 전체를 입력하십시오.</translation>
        </message>
        <message>
            <source>“%1” for %2 is not a number: type a diameter such as %3.</source>
            <translation>%2의 “%1”은(는) 숫자가 아닙니다. %3처럼 지름을 입력하십시오.</translation>
        </message>
        <message>
            <source>Not taken for %1: %2</source>
            <translation>%1: 받지 않았습니다. %2</translation>
        </message>
        <message>
            <source>Yes, %1</source>
            <translation>예, %1</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>%1: being stored …</source>
            <translation>%1: 저장하는 중 …</translation>
        </message>
        <message>
            <source>Not stored, %1 is kept here: %2 Enter tries again.</source>
            <translation>저장되지 않아 %1을(를) 여기에 두었습니다: %2 입력 키를 누르면 다시 시도합니다.</translation>
        </message>
        <message>
            <source>%1: %2 from the gauge, stored.</source>
            <translation>%1: 게이지 값 %2 저장됨.</translation>
        </message>
        <message>
            <source>%1: %2 stored.</source>
            <translation>%1: %2 저장됨.</translation>
        </message>
        <message>
            <source>The gauge sent %1, but no part waits for a diameter: left out.</source>
            <translation>게이지가 %1을(를) 보냈으나 측정 대기 공작물이 없어 버렸습니다.</translation>
        </message>
        <message>
            <source>the gauge sent %1: that fits only in inch. Set the gauge to mm.</source>
            <translation>게이지가 %1을(를) 보냈는데 인치로만 맞습니다. 게이지를 mm로 맞추십시오.</translation>
        </message>
        <message>
            <source>the gauge sent %1: that fits only in mm. Set the gauge to inch.</source>
            <translation>게이지가 %1을(를) 보냈는데 mm로만 맞습니다. 게이지를 인치로 맞추십시오.</translation>
        </message>
        <message>
            <source>Take %1</source>
            <translation>%1 받기</translation>
        </message>
        <message>
            <source>the gauge sent %1: its decimal point seems to have slipped.</source>
            <translation>게이지가 %1을(를) 보냈는데 소수점이 밀린 것 같습니다.</translation>
        </message>
        <message>
            <source>The gauge sent %1 twice at once: the second one is left out.</source>
            <translation>게이지가 %1을(를) 한꺼번에 두 번 보내 두 번째는 버렸습니다.</translation>
        </message>
        <message>
            <source>Further readings are left out until this one is stored: send them again then.</source>
            <translation>이 값이 저장될 때까지 다음 측정값은 제외됩니다. 저장된 뒤 다시 보내십시오.</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <comment>gauge channel, depth</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>Gauge channels</source>
            <translation>게이지 채널</translation>
        </message>
        <message>
            <source>The gauge sent %1, but channel %2 belongs to no depth: left out.</source>
            <translation>게이지 값 %1: 채널 %2에 지정된 깊이가 없어 제외했습니다.</translation>
        </message>
        <message>
            <source>The gauge sent %1 at once behind the others: one too many, left out. For the next part send it again.</source>
            <translation>게이지 값 %1: 연달아 하나 더 들어와 제외했습니다. 다음 공작물의 값이면 다시 보내십시오.</translation>
        </message>
        <message>
            <source>The gauge sent %1, but %2 has its diameter: left out. Use Correct to change it.</source>
            <translation>게이지 값 %1: %2의 지름이 이미 있어 제외했습니다. 바꾸려면 ‘수정’을 누르십시오.</translation>
        </message>
        <message>
            <source>The gauge sent %1: a deviation, and the recipe has no setting ring. Not taken.</source>
            <translation>게이지 값 %1: 편차인데 레시피에 세팅 링이 없어 받지 않았습니다.</translation>
        </message>
        <message>
            <source>Only a part of a reading came (%1): nothing is taken. Send it again.</source>
            <translation>측정값의 일부만 들어왔습니다(%1). 받지 않았으니 다시 보내십시오.</translation>
        </message>
        <message>
            <source>Num Lock is off: the keypad sends no figures. Switch it on and type again.</source>
            <translation>Num Lock이 꺼져 있어 숫자가 입력되지 않습니다. 켜고 다시 입력하십시오.</translation>
        </message>
        <message>
            <source>%1 is kept here and is stored as soon as there is room: %2</source>
            <translation>%1: 여기에 보관하며 자리가 나면 저장합니다: %2</translation>
        </message>
        <message>
            <source>The gauge sent %1 for depth %2 of the sensor file; this part type has %3: left out.</source>
            <translation>게이지가 센서 파일의 깊이 %2에 %1을(를) 보냈지만 이 품종의 깊이는 %3개입니다. 받지 않았습니다.</translation>
        </message>
        <message>
            <source>Which gauge?</source>
            <translation>어느 게이지?</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ErrorMap</name>
        <message>
            <source>error in %1, %2</source>
            <translation>%1 오차, %2</translation>
        </message>
        <message>
            <source>X 0 to %1, Y 0 to %2</source>
            <translation>X 0~%1, Y 0~%2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::EstimatePanel</name>
        <message>
            <source>%1, 95 % intervals</source>
            <comment>of estimated figures</comment>
            <translation>%1, 95 % 구간</translation>
        </message>
        <message>
            <source>%1 (%2), 95 % intervals</source>
            <comment>estimated figures, by which estimator</comment>
            <translation>%1 (%2), 95 % 구간</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::EstimateStrips</name>
        <message>
            <source>The estimated constants of the law appear here after the first measured part.</source>
            <translation>첫 공작물을 측정하면 추정한 상수가 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>part</source>
            <translation>공작물</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::FeedPanel</name>
        <message>
            <source>Feed along the bore, %1</source>
            <comment>unit</comment>
            <translation>내경을 따른 이송, %1</translation>
        </message>
        <message>
            <source>overhang</source>
            <translation>돌출 길이</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>이송</translation>
        </message>
        <message>
            <source>schedule</source>
            <translation>계획</translation>
        </message>
        <message>
            <source>last part</source>
            <translation>직전 공작물</translation>
        </message>
        <message>
            <source>The feed schedule appears here as soon as a lot is running.</source>
            <translation>로트가 돌기 시작하면 이송 계획이 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Feed along the bore: schedule, last part, live cut</source>
            <translation>내경을 따른 이송: 계획, 직전 공작물, 현재 가공</translation>
        </message>
        <message>
            <source>live %1</source>
            <translation>현재 %1</translation>
        </message>
        <message>
            <source>not cutting</source>
            <translation>가공 안 함</translation>
        </message>
        <message>
            <source>feed not known</source>
            <translation>이송을 알 수 없음</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ForcePanel</name>
        <message>
            <source>Force, %1: extremes and mean, last %2 s</source>
            <comment>unit, seconds</comment>
            <translation>힘, %1: 최소·최대와 평균, 최근 %2 s</translation>
        </message>
        <message>
            <source>Depth, %1, last %2 s</source>
            <comment>unit, seconds</comment>
            <translation>깊이, %1, 최근 %2 s</translation>
        </message>
        <message>
            <source>force</source>
            <translation>힘</translation>
        </message>
        <message>
            <source>depth</source>
            <translation>깊이</translation>
        </message>
        <message>
            <source>from the force</source>
            <translation>힘에서 얻은 값</translation>
        </message>
        <message>
            <source>The force appears here as soon as a part is cut.</source>
            <translation>공작물을 절삭하면 여기에 힘이 나타납니다.</translation>
        </message>
        <message>
            <source>The depth that is really cut appears here with the first chip.</source>
            <translation>첫 칩과 함께 실제 절삭 깊이가 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Force live: lowest and highest of every 5 kHz sample, mean, target</source>
            <translation>실시간 힘: 5 kHz 샘플의 최소와 최대, 평균, 목표</translation>
        </message>
        <message>
            <source>Depth from the force against the programmed depth</source>
            <translation>힘에서 얻은 깊이와 프로그램 깊이</translation>
        </message>
        <message>
            <source>target</source>
            <translation>목표</translation>
        </message>
        <message>
            <source>programmed</source>
            <translation>프로그램</translation>
        </message>
        <message>
            <source>mean %1</source>
            <translation>평균 %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::GainsPanel</name>
        <message>
            <source>before</source>
            <translation>전</translation>
        </message>
        <message>
            <source>now</source>
            <translation>현재</translation>
        </message>
        <message>
            <source>next</source>
            <translation>다음</translation>
        </message>
        <message>
            <source>trim, %1</source>
            <comment>largest learned trim, unit</comment>
            <translation>보정, %1</translation>
        </message>
        <message>
            <source>Safe Z gain %1 to %2 1/s; unstable from about %3 1/s, %4 dB away.</source>
            <translation>안전한 Z 게인 %1~%2 1/s; 약 %3 1/s부터 불안정, 여유 %4 dB.</translation>
        </message>
        <message>
            <source>The safe set of gains is estimated with the first trial tap.</source>
            <translation>안전한 게인 범위는 첫 시험 탭에서 추정됩니다.</translation>
        </message>
        <message>
            <source>This machine has no tapping loop: %1</source>
            <translation>이 기계에는 탭 루프가 없습니다: %1</translation>
        </message>
        <message>
            <source>Tune again: the sum of errors has grown above that of the first taps.</source>
            <translation>다시 튜닝하십시오: 오차 합이 처음 탭들보다 커졌습니다.</translation>
        </message>
        <message>
            <source>Drift watch: %1 % of what asks for a new tune, after %2 taps.</source>
            <translation>변화 감시: 재튜닝 기준의 %1 %, 탭 %2회 후.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::GaugeSheets</name>
        <message>
            <source>no study yet</source>
            <translation>아직 평가 없음</translation>
        </message>
        <message>
            <source>σ %1 (%2 to %3), from a study: %4</source>
            <comment>repeatability with its interval, judgement</comment>
            <translation>σ %1 (%2~%3), 평가 결과: %4</translation>
        </message>
        <message>
            <source>good enough</source>
            <translation>충분함</translation>
        </message>
        <message>
            <source>not good enough</source>
            <translation>부족함</translation>
        </message>
        <message>
            <source>no due date</source>
            <translation>교정 기한 없음</translation>
        </message>
        <message>
            <source>overdue since %1</source>
            <translation>%1부터 기한 경과</translation>
        </message>
        <message>
            <source>due on %1</source>
            <translation>기한 %1</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>게이지</translation>
        </message>
        <message>
            <source>Choose a gauge, or enter a new one.</source>
            <translation>게이지를 선택하거나 새로 입력하십시오.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>New gauge</source>
            <translation>새 게이지</translation>
        </message>
        <message>
            <source>Lengths in mm; the due date as 2026-12-31.</source>
            <translation>길이는 mm, 기한은 2026-12-31 형식입니다.</translation>
        </message>
        <message>
            <source>Identity</source>
            <translation>식별 번호</translation>
        </message>
        <message>
            <source>Range from</source>
            <translation>범위 시작</translation>
        </message>
        <message>
            <source>Range to</source>
            <translation>범위 끝</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>분해능</translation>
        </message>
        <message>
            <source>Setting ring</source>
            <translation>세팅 링</translation>
        </message>
        <message>
            <source>Due date</source>
            <translation>교정 기한</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Study with one ring</source>
            <translation>링 하나로 평가</translation>
        </message>
        <message>
            <source>Study with parts and persons</source>
            <translation>공작물과 사람으로 평가</translation>
        </message>
        <message>
            <source>Use σ for the lots to come</source>
            <translation>다음 로트부터 이 σ 사용</translation>
        </message>
        <message>
            <source>Numbers and a date as 2026-12-31 are needed.</source>
            <translation>숫자와 2026-12-31 형식의 날짜가 필요합니다.</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>저장</translation>
        </message>
        <message>
            <source>No lot is open, so there is no recipe to take it.</source>
            <translation>열린 로트가 없어 적용할 레시피가 없습니다.</translation>
        </message>
        <message>
            <source>Stored as a new revision of the recipe: it holds for the next lot.</source>
            <translation>레시피의 새 개정으로 저장했습니다. 다음 로트부터 적용됩니다.</translation>
        </message>
        <message>
            <source>All %1 readings are there. Save the study.</source>
            <translation>측정값 %1개가 모두 있습니다. 평가를 저장하십시오.</translation>
        </message>
        <message>
            <source>Reading %1 of %2 of the ring</source>
            <translation>링 측정 %1/%2</translation>
        </message>
        <message>
            <source>Person %1, trial %2: part %3</source>
            <translation>사람 %1, 반복 %2: 공작물 %3</translation>
        </message>
        <message>
            <source>10 parts, 3 persons, 2 trials each. The person changes when all parts have been read twice.</source>
            <translation>공작물 10개, 사람 3명, 각 2회 반복. 모든 공작물을 두 번 측정하면 사람이 바뀝니다.</translation>
        </message>
        <message>
            <source>25 readings of the setting ring, taken out and put back each time.</source>
            <translation>세팅 링을 매번 뺐다 넣으며 25회 측정합니다.</translation>
        </message>
        <message>
            <source>Width of the tolerance, mm</source>
            <translation>공차 폭, mm</translation>
        </message>
        <message>
            <source>Reading, mm</source>
            <translation>측정값, mm</translation>
        </message>
        <message>
            <source>“%1” does not lie in the range of the gauge. Read again.</source>
            <translation>“%1”은(는) 게이지 범위 밖입니다. 다시 측정하십시오.</translation>
        </message>
        <message>
            <source>Take back the last reading</source>
            <translation>마지막 측정 취소</translation>
        </message>
        <message>
            <source>Save the study</source>
            <translation>평가 저장</translation>
        </message>
        <message>
            <source>%1 of %2 readings are there; the tolerance must be a number.</source>
            <translation>측정값 %1/%2개가 있습니다. 공차는 숫자여야 합니다.</translation>
        </message>
        <message>
            <source>Study with one ring, n %1, tolerance %2: Cg %3, Cgk %4</source>
            <translation>링 하나로 평가, n %1, 공차 %2: Cg %3, Cgk %4</translation>
        </message>
        <message>
            <source>Study with one ring, n %1, tolerance %2: Cg %3</source>
            <translation>링 하나로 평가, n %1, 공차 %2: Cg %3</translation>
        </message>
        <message>
            <source>Study with parts and persons, n %1: GRR %2 % of the spread of the parts, %3 % of the tolerance %4, %5 categories</source>
            <translation>공작물과 사람으로 평가, n %1: GRR은 공작물 산포의 %2 %, 공차 %4의 %3 %, 구별 범주 %5개</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HeaderBar</name>
        <message>
            <source>lot %1</source>
            <translation>로트 %1</translation>
        </message>
        <message>
            <source>part %1/%2</source>
            <translation>공작물 %1/%2</translation>
        </message>
        <message>
            <source>emergency stop</source>
            <translation>비상정지</translation>
        </message>
        <message>
            <source>connected</source>
            <translation>연결됨</translation>
        </message>
        <message>
            <source>machine off</source>
            <translation>기계 꺼짐</translation>
        </message>
        <message>
            <source>connecting</source>
            <translation>연결 중</translation>
        </message>
        <message>
            <source>no link</source>
            <translation>연결 없음</translation>
        </message>
        <message>
            <source>simulator ×%1</source>
            <translation>시뮬레이터 ×%1</translation>
        </message>
        <message>
            <source>simulator, free run</source>
            <translation>시뮬레이터, 최대 속도</translation>
        </message>
        <message>
            <source>Sign on</source>
            <translation>로그인</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>언어</translation>
        </message>
        <message>
            <source>Settings</source>
            <translation>설정</translation>
        </message>
        <message>
            <source>closed</source>
            <translation>닫힘</translation>
        </message>
        <message>
            <source>full</source>
            <translation>완료</translation>
        </message>
        <message>
            <source>Lots</source>
            <translation>로트</translation>
        </message>
        <message>
            <source>Help: touch what you want explained</source>
            <translation>도움말: 궁금한 것을 누르십시오</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HeldBand</name>
        <message>
            <source>HELD: all loops</source>
            <translation>홀드: 모든 루프</translation>
        </message>
        <message>
            <source>STOPPED: a tap stands in the hole</source>
            <translation>정지: 탭이 구멍 안에 서 있음</translation>
        </message>
        <message>
            <source>STOPPED: %1</source>
            <translation>정지: %1</translation>
        </message>
        <message>
            <source>Emergency stop is pressed.</source>
            <translation>비상 정지가 눌려 있습니다.</translation>
        </message>
        <message>
            <source>No link to the machine.</source>
            <translation>기계와 연결되지 않았습니다.</translation>
        </message>
        <message>
            <source>The machine is off.</source>
            <translation>기계가 꺼져 있습니다.</translation>
        </message>
        <message>
            <source>HOLD ALL was pressed by %1.</source>
            <translation>%1 님이 전체 홀드를 눌렀습니다.</translation>
        </message>
        <message>
            <source>HOLD ALL was pressed, or the machine was stopped or lost: look at it.</source>
            <translation>전체 홀드가 눌렸거나 기계가 정지 또는 연결이 끊겼습니다. 기계를 확인하십시오.</translation>
        </message>
        <message>
            <source>since %1</source>
            <translation>%1부터</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>보기</translation>
        </message>
        <message>
            <source>Release stop</source>
            <translation>정지 해제</translation>
        </message>
        <message>
            <source>Release hold</source>
            <translation>홀드 해제</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HelpMode</name>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>The formula</source>
            <translation>수식</translation>
        </message>
        <message>
            <source>The guide</source>
            <translation>설명서</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HistogramChart</name>
        <message>
            <source>Appears as soon as the engine cycles.</source>
            <translation>엔진이 돌기 시작하면 나타납니다.</translation>
        </message>
        <message>
            <source>cycle</source>
            <translation>주기</translation>
        </message>
        <message>
            <source>median %1</source>
            <translation>중앙값 %1</translation>
        </message>
        <message>
            <source>99.9 % %1</source>
            <translation>99.9 % %1</translation>
        </message>
        <message>
            <source>worst %1</source>
            <translation>최악 %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::HoldAllButton</name>
        <message>
            <source>HELD – all loops off</source>
            <translation>홀드됨 – 모든 루프 꺼짐</translation>
        </message>
        <message>
            <source>HOLD ALL</source>
            <translation>전체 홀드</translation>
        </message>
        <message>
            <source>All loops off, last offset held (Pause key). This is not an emergency stop.</source>
            <translation>모든 루프를 끄고 마지막 보정값을 유지합니다(Pause 키). 비상정지가 아닙니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ImportForm</name>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>being read</source>
            <translation>읽는 중</translation>
        </message>
        <message>
            <source>choose a file first</source>
            <translation>먼저 파일을 고르십시오</translation>
        </message>
        <message>
            <source>Diameters from a file</source>
            <translation>파일에서 지름 가져오기</translation>
        </message>
        <message>
            <source>A table with the columns part, overhang and diameter, in any order and spelling. Nothing is taken before you have seen what it would do.</source>
            <translation>공작물, 돌출 길이, 지름 열이 있는 표(순서와 표기는 자유). 무엇이 바뀔지 본 뒤에만 받아들입니다.</translation>
        </message>
        <message>
            <source>or the file's path</source>
            <translation>또는 파일 경로</translation>
        </message>
        <message>
            <source>File</source>
            <translation>파일</translation>
        </message>
        <message>
            <source>Look into it</source>
            <translation>살펴보기</translation>
        </message>
        <message>
            <source>Take over</source>
            <translation>받아들이기</translation>
        </message>
        <message>
            <source>a moment</source>
            <translation>잠시만</translation>
        </message>
        <message>
            <source>look into a file first</source>
            <translation>먼저 파일을 살펴보십시오</translation>
        </message>
        <message>
            <source>it cannot be read</source>
            <translation>읽을 수 없음</translation>
        </message>
        <message>
            <source>a row is refused</source>
            <translation>거부된 행이 있음</translation>
        </message>
        <message>
            <source>nothing new in it</source>
            <translation>새로운 값이 없음</translation>
        </message>
        <message>
            <source>A moment …</source>
            <translation>잠시만 …</translation>
        </message>
        <message>
            <source>Nothing is taken: %1</source>
            <translation>아무것도 받아들이지 않습니다: %1</translation>
        </message>
        <message>
            <source>Line %1: %2</source>
            <translation>%1행: %2</translation>
        </message>
        <message>
            <source>%1 would be entered: %2 diameters of parts %3 to %4, from %5 to %6.</source>
            <translation>%1: 공작물 %3~%4의 지름 %2개가 입력됩니다. 범위 %5~%6.</translation>
        </message>
        <message>
            <source>%1 diameters taken over from %2.</source>
            <translation>%2에서 지름 %1개를 받아들였습니다.</translation>
        </message>
        <message>
            <source>Yes, take all %1 as they are</source>
            <translation>예, %1개 모두 그대로 받기</translation>
        </message>
        <message>
            <source>Take %1 diameters</source>
            <translation>지름 %1개 받기</translation>
        </message>
        <message>
            <source>%1 of its values are stored already.</source>
            <translation>그중 %1개는 이미 저장되어 있습니다.</translation>
        </message>
        <message>
            <source>… and %1 more like it.</source>
            <translation>… 같은 것이 %1개 더 있습니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::JobForm</name>
        <message>
            <source>What is tapped</source>
            <translation>탭 작업</translation>
        </message>
        <message>
            <source>coarse</source>
            <translation>보통나사</translation>
        </message>
        <message>
            <source>fine</source>
            <translation>가는나사</translation>
        </message>
        <message>
            <source>speed</source>
            <translation>속도</translation>
        </message>
        <message>
            <source>depth</source>
            <translation>깊이</translation>
        </message>
        <message>
            <source>gear</source>
            <translation>기어</translation>
        </message>
        <message>
            <source>part type no.</source>
            <translation>품종 번호</translation>
        </message>
        <message>
            <source>tap no.</source>
            <translation>탭 번호</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Load</source>
            <translation>로드</translation>
        </message>
        <message>
            <source>%1: pitch diameter 6H (ISO 965-1) allows %2 p-p in the work, %3 with a tap at its upper limit.</source>
            <translation>%1: 유효지름 6H(ISO 965-1)는 가공 구간에서 p-p %2, 탭이 상한이면 %3까지 허용합니다.</translation>
        </message>
        <message>
            <source>Reason</source>
            <translation>사유</translation>
        </message>
        <message>
            <source>A stored tuning is left out, %1.</source>
            <comment>by whom and why</comment>
            <translation>저장된 튜닝 하나가 제외되었습니다, %1.</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>다시 포함</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>제외</translation>
        </message>
        <message>
            <source>%1: pitch diameter 2B (ASME B1.1) allows %2 p-p in the work, %3 with a tap at its upper limit.</source>
            <translation>%1: 유효지름 2B(ASME B1.1) 허용치는 가공 중 %2 p-p, 상한에 있는 탭이면 %3입니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::Keypad</name>
        <message>
            <source>Enter</source>
            <translation>입력</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>지우기</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::LastVerdict</name>
        <message>
            <source>Part %1: %2, no limits are set</source>
            <translation>공작물 %1: %2, 한계가 설정되지 않음</translation>
        </message>
        <message>
            <source>Part %1: %2, %3</source>
            <comment>verdict, figure</comment>
            <translation>공작물 %1: %2, %3</translation>
        </message>
        <message>
            <source>Part %1: %2</source>
            <translation>공작물 %1: %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::LoopCard</name>
        <message>
            <source>not fitted</source>
            <translation>미장착</translation>
        </message>
        <message>
            <source>Not fitted yet.</source>
            <translation>아직 장착되지 않았습니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::LotForm</name>
        <message>
            <source>Lots</source>
            <translation>로트</translation>
        </message>
        <message>
            <source>Next lot of part type</source>
            <translation>다음 로트의 품종</translation>
        </message>
        <message>
            <source>Lot</source>
            <translation>로트</translation>
        </message>
        <message>
            <source>Estimator kalman</source>
            <translation>추정기 kalman</translation>
        </message>
        <message>
            <source>perturbation (paper)</source>
            <translation>perturbation (논문)</translation>
        </message>
        <message>
            <source>Reason, when the lot is closed before it is full</source>
            <translation>다 차기 전에 로트를 닫는 사유</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>뒤로</translation>
        </message>
        <message>
            <source>Close this lot</source>
            <translation>이 로트 닫기</translation>
        </message>
        <message>
            <source>Recipe</source>
            <translation>레시피</translation>
        </message>
        <message>
            <source>New part type</source>
            <translation>새 품종</translation>
        </message>
        <message>
            <source>Go on with it</source>
            <translation>이 로트 계속</translation>
        </message>
        <message>
            <source>Open the lot</source>
            <translation>로트 열기</translation>
        </message>
        <message>
            <source>It is closed.</source>
            <translation>닫혔습니다.</translation>
        </message>
        <message>
            <source>It is full.</source>
            <translation>다 찼습니다.</translation>
        </message>
        <message>
            <source>It goes on.</source>
            <translation>진행 중입니다.</translation>
        </message>
        <message>
            <source>Now: %1, lot %2, %3 of %4 parts cut, recipe revision %5. %6</source>
            <comment>part type, lot, counts, state</comment>
            <translation>현재: %1, 로트 %2, 공작물 %4개 중 %3개 절삭, 레시피 개정 %5. %6</translation>
        </message>
        <message>
            <source>Part type</source>
            <translation>품종</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>Opened</source>
            <translation>연 시각</translation>
        </message>
        <message>
            <source>State</source>
            <translation>상태</translation>
        </message>
        <message>
            <source>current</source>
            <translation>현재</translation>
        </message>
        <message>
            <source>closed</source>
            <translation>닫힘</translation>
        </message>
        <message>
            <source>open</source>
            <translation>열림</translation>
        </message>
        <message>
            <source>The newest recipe of the part type holds for a new lot, and stays with it.</source>
            <translation>새 로트에는 품종의 최신 레시피가 적용되고 끝까지 유지됩니다.</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>저장 중</translation>
        </message>
        <message>
            <source>a lot needs a name</source>
            <translation>로트 이름이 필요함</translation>
        </message>
        <message>
            <source>touch a lot in the list</source>
            <translation>목록에서 로트를 누르십시오</translation>
        </message>
        <message>
            <source>this lot is current</source>
            <translation>현재 로트임</translation>
        </message>
        <message>
            <source>it is closed</source>
            <translation>닫혀 있음</translation>
        </message>
        <message>
            <source>give a reason: it is not full</source>
            <translation>다 차지 않음: 사유를 쓰십시오</translation>
        </message>
        <message>
            <source>Lot %1 goes on.</source>
            <translation>로트 %1을(를) 계속합니다.</translation>
        </message>
        <message>
            <source>The lot is closed.</source>
            <translation>로트를 닫았습니다.</translation>
        </message>
        <message>
            <source>Insert grade</source>
            <translation>인서트 재종</translation>
        </message>
        <message>
            <source>Material</source>
            <translation>소재</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>다시 포함</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>제외</translation>
        </message>
        <message>
            <source>Counts</source>
            <comment>share of a lot in what this one began from</comment>
            <translation>비중</translation>
        </message>
        <message>
            <source>left out</source>
            <translation>제외됨</translation>
        </message>
        <message>
            <source>touch a lot that the current one begins from</source>
            <translation>현재 로트가 시작하는 데 쓰인 로트를 누르십시오</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>사유를 입력하십시오</translation>
        </message>
        <message>
            <source>Lot %1 counts again.</source>
            <translation>로트 %1을 다시 포함합니다.</translation>
        </message>
        <message>
            <source>Lot %1 is left out of what lots begin from.</source>
            <translation>로트 %1을 로트의 시작 값에서 제외합니다.</translation>
        </message>
        <message numerus="yes">
            <source>%n bores wait for diameters</source>
            <translation>
                <numerusform>내경 %n개 측정 대기</numerusform>
            </translation>
        </message>
        <message>
            <source>Part %1 of this lot waits for its diameter. It is kept when another lot is opened; go on with this lot to enter it.</source>
            <translation>이 로트의 공작물 %1: 지름 측정 대기 중. 다른 로트를 열어도 보관되며, 이 로트를 이어서 진행하면 입력할 수 있습니다.</translation>
        </message>
        <message>
            <source>Lot %1 is open. Its first part is started by hand.</source>
            <translation>로트 %1: 열렸습니다. 첫 공작물은 직접 시작합니다.</translation>
        </message>
        <message>
            <source>Lot %1 is open. Part %2 of lot %3 still waits for its diameter: Lots, Go on with it.</source>
            <translation>로트 %1: 열렸습니다. 로트 %3의 공작물 %2: 아직 지름 측정 대기 중. ‘로트’에서 ‘이어서 진행’을 누르십시오.</translation>
        </message>
        <message>
            <source>on machine %1</source>
            <translation>기계 %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MachineDrawing</name>
        <message>
            <source>The thermocouples appear here as soon as the machine reports them.</source>
            <translation>기계가 열전대를 알려 주면 여기에 나타납니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MachineStrip</name>
        <message>
            <source>Force</source>
            <translation>절삭력</translation>
        </message>
        <message>
            <source>%1, paused</source>
            <translation>%1, 일시 정지</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>프로그램</translation>
        </message>
        <message>
            <source>none runs</source>
            <translation>실행 없음</translation>
        </message>
        <message>
            <source>S</source>
            <translation>S</translation>
        </message>
        <message>
            <source>F</source>
            <translation>F</translation>
        </message>
        <message>
            <source>Knob</source>
            <translation>이송 오버라이드</translation>
        </message>
        <message>
            <source>Tool</source>
            <translation>공구</translation>
        </message>
        <message numerus="yes">
            <source>%n parts left</source>
            <translation>
                <numerusform>%n개 남음</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n parts</source>
            <translation>
                <numerusform>%n개</numerusform>
            </translation>
        </message>
        <message>
            <source>To go</source>
            <translation>남은 시간</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MainWindow</name>
        <message>
            <source>Not done: %1</source>
            <translation>실행되지 않음: %1</translation>
        </message>
        <message>
            <source>Kerf – operator console</source>
            <translation>Kerf – 작업자 콘솔</translation>
        </message>
        <message>
            <source>Simulator speed</source>
            <translation>시뮬레이터 속도</translation>
        </message>
        <message>
            <source>Machine time per second on the clock.</source>
            <translation>시계 1초에 흐르는 기계 시간입니다.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>gone since %1, not seen yet</source>
            <translation>%1 해소, 아직 확인 안 함</translation>
        </message>
        <message>
            <source>The data file</source>
            <translation>데이터 파일</translation>
        </message>
        <message>
            <source>Finished parts wait</source>
            <translation>완성된 공작물이 기다립니다</translation>
        </message>
        <message>
            <source>The store does not take %1 finished parts. Ending Kerf keeps them beside the data file; the next start stores them.</source>
            <translation>완성된 공작물 %1개가 저장되지 않고 있습니다. Kerf를 끝내면 데이터 파일 옆에 보관되고, 다음 시작 때 저장됩니다.</translation>
        </message>
        <message>
            <source>Stay</source>
            <translation>머무르기</translation>
        </message>
        <message>
            <source>End Kerf</source>
            <translation>Kerf 끝내기</translation>
        </message>
        <message>
            <source>A part is being cut</source>
            <translation>공작물을 가공하고 있습니다</translation>
        </message>
        <message>
            <source>Ending Kerf lets go of it: the machine goes on at or below its planned feed, with its last offset, and what is cut from now on is not recorded.</source>
            <translation>Kerf를 끝내면 손을 뗍니다. 기계는 계획된 이송 이하로 마지막 보정을 유지한 채 계속 가공하며, 이후의 가공은 기록되지 않습니다.</translation>
        </message>
        <message>
            <source>Touch what you want explained.</source>
            <translation>궁금한 것을 누르십시오.</translation>
        </message>
        <message>
            <source>Close what is open first: it keeps the language it was opened in.</source>
            <translation>열린 창을 먼저 닫으십시오. 열린 창은 열 때의 언어로 남아 있습니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MarginPanel</name>
        <message>
            <source>Margins appear as soon as a law acts.</source>
            <translation>제어 법칙이 작동하면 여유가 나타납니다.</translation>
        </message>
        <message>
            <source>Guaranteed for every process within the 95 % intervals.</source>
            <translation>95 % 구간 안의 모든 공정에 대해 보장됩니다.</translation>
        </message>
        <message>
            <source>For the process the law assumes; it is not identified.</source>
            <translation>법칙이 가정한 공정에 대한 값이며 식별된 것이 아닙니다.</translation>
        </message>
        <message>
            <source>trim %1 of ± %2</source>
            <comment>applied trim, authority</comment>
            <translation>보정 %1, 범위 ± %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MeasurementForm</name>
        <message>
            <source>%1: %2</source>
            <comment>part and depth, diameter</comment>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>The old value stays on record. The law and all later parts are computed again without it.</source>
            <translation>옛 값은 기록에 남습니다. 법칙과 뒤의 모든 공작물은 이 값 없이 다시 계산합니다.</translation>
        </message>
        <message>
            <source>Correct the value</source>
            <translation>값 수정</translation>
        </message>
        <message>
            <source>Take it out</source>
            <translation>값 빼기</translation>
        </message>
        <message>
            <source>typed wrong</source>
            <translation>입력 실수</translation>
        </message>
        <message>
            <source>measured wrong</source>
            <translation>측정 실수</translation>
        </message>
        <message>
            <source>wrong part or depth</source>
            <translation>공작물이나 깊이가 틀림</translation>
        </message>
        <message>
            <source>gauge not set</source>
            <translation>게이지 설정 안 됨</translation>
        </message>
        <message>
            <source>Why?</source>
            <translation>사유</translation>
        </message>
        <message>
            <source>or in your own words</source>
            <translation>또는 직접 쓰기</translation>
        </message>
        <message>
            <source>signed by %1</source>
            <translation>서명: %1</translation>
        </message>
        <message>
            <source>Leave as it is</source>
            <translation>그대로 두기</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>저장하는 중</translation>
        </message>
        <message>
            <source>nobody is signed on</source>
            <translation>로그인한 사람이 없음</translation>
        </message>
        <message>
            <source>the right diameter is missing</source>
            <translation>올바른 지름이 없음</translation>
        </message>
        <message>
            <source>a reason is missing</source>
            <translation>사유가 없음</translation>
        </message>
        <message>
            <source>Correct</source>
            <translation>수정</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>빼기</translation>
        </message>
        <message>
            <source>Not changed: %1</source>
            <translation>바뀌지 않음: %1</translation>
        </message>
        <message>
            <source>This bore then waits for a diameter again.</source>
            <translation>그러면 이 내경은 다시 지름을 기다립니다.</translation>
        </message>
        <message>
            <source>%1 becomes %2.</source>
            <comment>diameters</comment>
            <translation>%1을(를) %2(으)로 바꿉니다.</translation>
        </message>
        <message>
            <source>Type the right diameter: its last two figures, or the whole.</source>
            <translation>올바른 지름을 입력하십시오: 마지막 두 자리 또는 전체.</translation>
        </message>
        <message>
            <source>%1: %2 corrected to %3.</source>
            <translation>%1: %2을(를) %3(으)로 수정했습니다.</translation>
        </message>
        <message>
            <source>%1: %2 taken out.</source>
            <translation>%1: %2을(를) 뺐습니다.</translation>
        </message>
        <message>
            <source>Num Lock is off: the keypad sends no figures. Switch it on and type again.</source>
            <translation>Num Lock이 꺼져 있어 숫자가 입력되지 않습니다. 켜고 다시 입력하십시오.</translation>
        </message>
        <message>
            <source>The gauge sent %1: not used. To put it in, touch “Correct the value” first and send it again.</source>
            <translation>게이지 값 %1: 사용하지 않았습니다. 넣으려면 먼저 ‘값 수정’을 누르고 다시 보내십시오.</translation>
        </message>
        <message>
            <source>The gauge sent %1: a deviation, and the recipe has no setting ring. Not used.</source>
            <translation>게이지 값 %1: 편차인데 레시피에 세팅 링이 없어 사용하지 않았습니다.</translation>
        </message>
        <message>
            <source>Yes, %1</source>
            <translation>예, %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MeasurementList</name>
        <message>
            <source>part</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>⌀ %1</source>
            <translation>⌀ %1</translation>
        </message>
        <message>
            <source>enter</source>
            <translation>입력</translation>
        </message>
        <message>
            <source>%1 (corrected)</source>
            <translation>%1 (수정됨)</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingBlankForm</name>
        <message>
            <source>There is no step.</source>
            <translation>단이 없습니다.</translation>
        </message>
        <message>
            <source>Blank profile of %1</source>
            <translation>%1의 소재 형상</translation>
        </message>
        <message>
            <source>Height of the blank over the finished wall, step by step along the path.</source>
            <translation>경로를 따라 단마다, 완성된 벽 위 소재의 높이입니다.</translation>
        </message>
        <message>
            <source>path</source>
            <translation>경로</translation>
        </message>
        <message>
            <source>height</source>
            <translation>높이</translation>
        </message>
        <message>
            <source>The profile appears here with its first step.</source>
            <translation>첫 단을 넣으면 형상이 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Blank profile along the path</source>
            <translation>경로를 따른 소재 형상</translation>
        </message>
        <message>
            <source>Add step</source>
            <translation>단 추가</translation>
        </message>
        <message>
            <source>Remove last</source>
            <translation>마지막 삭제</translation>
        </message>
        <message>
            <source>Import CSV</source>
            <translation>CSV 가져오기</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Save and use</source>
            <translation>저장하고 사용</translation>
        </message>
        <message numerus="yes">
            <source>%n steps imported; look at the profile, then save.</source>
            <translation>
                <numerusform>%n단을 가져왔습니다. 형상을 확인한 뒤 저장하십시오.</numerusform>
            </translation>
        </message>
        <message>
            <source>The step that is typed is not added yet.</source>
            <translation>입력한 단이 아직 추가되지 않았습니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingControlPanel</name>
        <message>
            <source>Nothing is stopped.</source>
            <translation>멈춘 것이 없습니다.</translation>
        </message>
        <message>
            <source>reference force</source>
            <translation>기준 힘</translation>
        </message>
        <message>
            <source>peak of this cut</source>
            <translation>이번 절삭의 최대</translation>
        </message>
        <message>
            <source>Feed law</source>
            <translation>이송 제어 방식</translation>
        </message>
        <message>
            <source>Teach reference from this cut</source>
            <translation>이 절삭에서 기준 힘 배우기</translation>
        </message>
        <message>
            <source>Start cut</source>
            <translation>절삭 시작</translation>
        </message>
        <message>
            <source>Release feed</source>
            <translation>이송 해제</translation>
        </message>
        <message>
            <source>Milling</source>
            <translation>밀링</translation>
        </message>
        <message>
            <source>control would save</source>
            <translation>제어하면 절약</translation>
        </message>
        <message>
            <source>saved so far</source>
            <translation>지금까지 절약</translation>
        </message>
        <message>
            <source>%1 s above 110 % of the reference</source>
            <translation>기준 힘의 110 %를 %1 s 동안 넘음</translation>
        </message>
        <message>
            <source>; control would have stopped the feed</source>
            <translation>; 제어했다면 이송을 멈췄음</translation>
        </message>
        <message>
            <source>; the feed was stopped</source>
            <translation>; 이송을 멈췄음</translation>
        </message>
        <message>
            <source>This machine has no milling loop: %1</source>
            <translation>이 기계에는 밀링 루프가 없습니다: %1</translation>
        </message>
        <message>
            <source>No cut to learn from yet.</source>
            <translation>아직 배울 절삭이 없습니다.</translation>
        </message>
        <message>
            <source>This machine has no milling loop.</source>
            <translation>이 기계에는 밀링 루프가 없습니다.</translation>
        </message>
        <message>
            <source>No milling setup is loaded.</source>
            <translation>밀링 설정이 없습니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingLivePanel</name>
        <message>
            <source>Force per revolution, %1, and feed, %2</source>
            <comment>units</comment>
            <translation>회전당 힘, %1, 이송, %2</translation>
        </message>
        <message>
            <source>time</source>
            <translation>시간</translation>
        </message>
        <message>
            <source>force</source>
            <translation>힘</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>이송</translation>
        </message>
        <message>
            <source>average</source>
            <translation>평균</translation>
        </message>
        <message>
            <source>wanted</source>
            <translation>요구</translation>
        </message>
        <message>
            <source>The cutting force appears here with the next cut.</source>
            <translation>다음 절삭부터 절삭력이 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>The feed appears here with the next cut.</source>
            <translation>다음 절삭부터 이송이 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Cutting force averaged per revolution, over time</source>
            <translation>시간에 따른 회전당 평균 절삭력</translation>
        </message>
        <message>
            <source>Feed made and wanted, over time</source>
            <translation>시간에 따른 실제 이송과 요구 이송</translation>
        </message>
        <message>
            <source>Raw force</source>
            <translation>순간 절삭력</translation>
        </message>
        <message>
            <source>planned</source>
            <translation>계획</translation>
        </message>
        <message>
            <source>reference</source>
            <translation>기준</translation>
        </message>
        <message>
            <source>limit</source>
            <translation>한계</translation>
        </message>
        <message>
            <source>loop %1 Hz</source>
            <translation>루프 %1 Hz</translation>
        </message>
        <message>
            <source>breakage not seen</source>
            <translation>파손 감지 안 됨</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingPage</name>
        <message>
            <source>Nothing cut yet.</source>
            <translation>아직 가공한 것이 없습니다.</translation>
        </message>
        <message>
            <source>This machine has no milling loop.</source>
            <translation>이 기계에는 밀링 루프가 없습니다.</translation>
        </message>
        <message>
            <source>Setup</source>
            <translation>설정</translation>
        </message>
        <message>
            <source>Blank profile</source>
            <translation>소재 형상</translation>
        </message>
        <message>
            <source>Cut log</source>
            <translation>절삭 기록</translation>
        </message>
        <message>
            <source>New tool</source>
            <translation>새 공구</translation>
        </message>
        <message>
            <source>Milling data: %1</source>
            <translation>밀링 데이터: %1</translation>
        </message>
        <message>
            <source>A part is being cut.</source>
            <translation>공작물을 가공하고 있습니다.</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>저장하는 중</translation>
        </message>
        <message>
            <source>New tool?</source>
            <translation>새 공구입니까?</translation>
        </message>
        <message>
            <source>Wear and stiffness of the tool are learnt anew from the next cut on.</source>
            <translation>다음 절삭부터 공구의 마모와 강성을 새로 배웁니다.</translation>
        </message>
        <message>
            <source>No</source>
            <translation>아니요</translation>
        </message>
        <message>
            <source>Tools before</source>
            <translation>이전 공구</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingSetupForm</name>
        <message>
            <source>This part type is open.</source>
            <translation>이 품종이 열려 있습니다.</translation>
        </message>
        <message>
            <source>No part type of this name is stored.</source>
            <translation>이 이름으로 저장된 품종이 없습니다.</translation>
        </message>
        <message>
            <source>%1: %2 to %3; default %4, %5.</source>
            <comment>label, lowest, highest, default, source</comment>
            <translation>%1: %2에서 %3까지, 기본값 %4, %5.</translation>
        </message>
        <message>
            <source>Setup of a milled part type</source>
            <translation>밀링 품종 설정</translation>
        </message>
        <message>
            <source>Part type</source>
            <translation>품종</translation>
        </message>
        <message>
            <source>Force and feed</source>
            <translation>힘과 이송</translation>
        </message>
        <message>
            <source>Path and tool</source>
            <translation>경로와 공구</translation>
        </message>
        <message>
            <source>Model and gains</source>
            <translation>모델과 게인</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>열기</translation>
        </message>
        <message>
            <source>Save and use</source>
            <translation>저장하고 사용</translation>
        </message>
        <message>
            <source>Stored part types ▾</source>
            <translation>저장된 품종 ▾</translation>
        </message>
        <message>
            <source>Reason, when a limit is raised</source>
            <translation>한계를 올릴 때의 사유</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingToolPanel</name>
        <message>
            <source>part</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>The wear of the tool appears here after its first part.</source>
            <translation>첫 공작물이 끝나면 공구 마모가 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Mean cutting stiffness over the parts cut with this tool</source>
            <translation>이 공구로 가공한 공작물별 평균 절삭 강성</translation>
        </message>
        <message>
            <source>change the tool</source>
            <translation>공구 교환</translation>
        </message>
        <message>
            <source>New tool: nothing cut with it yet.</source>
            <translation>새 공구: 아직 가공하지 않았습니다.</translation>
        </message>
        <message>
            <source>Part %1 with this tool, stiffness %2 % above new.</source>
            <comment>parts, rise</comment>
            <translation>이 공구로 %1번째, 강성이 새 공구보다 %2 % 높음.</translation>
        </message>
        <message>
            <source>Trend %1 % per part.</source>
            <translation>추세 공작물당 %1 %.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::MillingWallPanel</name>
        <message>
            <source>Wall deviation, %1</source>
            <comment>unit</comment>
            <translation>벽 편차, %1</translation>
        </message>
        <message>
            <source>path</source>
            <translation>경로</translation>
        </message>
        <message>
            <source>deviation</source>
            <translation>편차</translation>
        </message>
        <message>
            <source>cut before</source>
            <translation>앞 절삭</translation>
        </message>
        <message>
            <source>The estimated wall appears here while a part is being cut.</source>
            <translation>가공하는 동안 추정한 벽이 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Estimated deviation of the wall along the path</source>
            <translation>경로를 따라 추정한 벽의 편차</translation>
        </message>
        <message>
            <source>waviness %1</source>
            <translation>파상도 %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::NextPartPanel</name>
        <message>
            <source>feed, top to bottom of the bore</source>
            <translation>이송, 내경 위에서 아래로</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>수락</translation>
        </message>
        <message>
            <source>at limit</source>
            <translation>한계</translation>
        </message>
        <message>
            <source>Next part: %1</source>
            <translation>다음 공작물: %1</translation>
        </message>
        <message>
            <source>⌀ %1, expected</source>
            <translation>⌀ %1, 예상</translation>
        </message>
        <message>
            <source>%1 → %2</source>
            <comment>feed at the top and at the bottom of the bore</comment>
            <translation>%1 → %2</translation>
        </message>
        <message>
            <source>This machine has no boring loop: %1</source>
            <translation>이 기계에는 보링 루프가 없습니다: %1</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>저장하는 중</translation>
        </message>
        <message>
            <source>no schedule yet</source>
            <translation>아직 계획이 없음</translation>
        </message>
        <message>
            <source>the loop is off</source>
            <translation>루프가 꺼져 있음</translation>
        </message>
        <message>
            <source>in control, every schedule is used by itself</source>
            <translation>제어 중에는 모든 계획이 저절로 쓰입니다</translation>
        </message>
        <message>
            <source>this schedule is accepted</source>
            <translation>이 계획은 수락되었습니다</translation>
        </message>
        <message>
            <source>Next lot</source>
            <translation>다음 로트</translation>
        </message>
        <message>
            <source>Lot %1 is closed</source>
            <translation>로트 %1 닫힘</translation>
        </message>
        <message>
            <source>Lot %1 is full: %2 parts</source>
            <translation>로트 %1 완료: 공작물 %2개</translation>
        </message>
        <message>
            <source>Announced: %1</source>
            <translation>예고됨: %1</translation>
        </message>
        <message>
            <source>Tool or material changed</source>
            <translation>공구나 소재 변경</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::NumberDisplay</name>
        <message>
            <source>%1 s old</source>
            <translation>%1 s 전</translation>
        </message>
        <message>
            <source>at limit</source>
            <translation>한계</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::OffsetPanel</name>
        <message>
            <source>at limit</source>
            <translation>한계</translation>
        </message>
        <message>
            <source>shifted %1</source>
            <translation>보정 %1</translation>
        </message>
        <message>
            <source>shift not reported</source>
            <translation>보정량 보고 없음</translation>
        </message>
        <message>
            <source>shifted %1, would be %2</source>
            <translation>보정 %1, 제안 %2</translation>
        </message>
        <message>
            <source>This machine has no thermal loop: %1</source>
            <translation>이 기계에는 열변위 루프가 없습니다: %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::OperatorSession</name>
        <message>
            <source>operator</source>
            <translation>작업자</translation>
        </message>
        <message>
            <source>setter</source>
            <translation>셋업 담당자</translation>
        </message>
        <message>
            <source>process engineer</source>
            <translation>공정 엔지니어</translation>
        </message>
        <message>
            <source>Only a process engineer may do this.</source>
            <translation>공정 엔지니어만 할 수 있습니다.</translation>
        </message>
        <message>
            <source>Only a setter or a process engineer may do this.</source>
            <translation>셋업 담당자나 공정 엔지니어만 할 수 있습니다.</translation>
        </message>
        <message>
            <source>Only a process engineer may give this role.</source>
            <translation>이 역할은 공정 엔지니어만 줄 수 있습니다.</translation>
        </message>
        <message>
            <source>Several wrong PINs were typed: wait %1 s.</source>
            <translation>틀린 PIN이 여러 번 입력되었습니다. %1초 기다리십시오.</translation>
        </message>
        <message>
            <source>Sign on first.</source>
            <translation>먼저 로그인하십시오.</translation>
        </message>
        <message>
            <source>Nobody takes himself off the list.</source>
            <translation>자기 자신은 목록에서 뺄 수 없습니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::OverviewPage</name>
        <message>
            <source>Nothing is held.</source>
            <translation>홀드된 것이 없습니다.</translation>
        </message>
        <message>
            <source>All loops are held with their last offset.</source>
            <translation>모든 루프가 마지막 보정값으로 홀드되어 있습니다.</translation>
        </message>
        <message>
            <source>Ready for the next part.</source>
            <translation>다음 공작물을 가공할 준비가 되었습니다.</translation>
        </message>
        <message>
            <source>Cutting, %1 s to go.</source>
            <translation>가공 중, %1 s 남음.</translation>
        </message>
        <message>
            <source>The program is running.</source>
            <translation>프로그램이 돌고 있습니다.</translation>
        </message>
        <message>
            <source>The program is paused.</source>
            <translation>프로그램이 멈춰 있습니다.</translation>
        </message>
        <message>
            <source>Part finished.</source>
            <translation>공작물을 끝냈습니다.</translation>
        </message>
        <message>
            <source>The last part was aborted.</source>
            <translation>직전 공작물은 중단되었습니다.</translation>
        </message>
        <message>
            <source>cutting</source>
            <translation>가공 중</translation>
        </message>
        <message>
            <source>ready</source>
            <translation>준비</translation>
        </message>
        <message>
            <source>off</source>
            <translation>꺼짐</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>기계</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>이송</translation>
        </message>
        <message>
            <source>Parts since start</source>
            <translation>시작 후 공작물</translation>
        </message>
        <message>
            <source>Start part</source>
            <translation>가공 시작</translation>
        </message>
        <message>
            <source>Release hold</source>
            <translation>홀드 해제</translation>
        </message>
        <message>
            <source>Stopped: %1</source>
            <translation>정지됨: %1</translation>
        </message>
        <message>
            <source>Release stop</source>
            <translation>정지 해제</translation>
        </message>
        <message>
            <source>Shop: %1</source>
            <translation>공장 서버: %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::PartDetailPanel</name>
        <message>
            <source>overhang</source>
            <translation>돌출 길이</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>이송</translation>
        </message>
        <message>
            <source>feed, %1</source>
            <comment>unit</comment>
            <translation>이송, %1</translation>
        </message>
        <message>
            <source>schedule</source>
            <translation>계획</translation>
        </message>
        <message>
            <source>cut</source>
            <translation>가공</translation>
        </message>
        <message>
            <source>The feed of the part appears here when one is chosen.</source>
            <translation>공작물을 고르면 이송이 여기에 표시됩니다.</translation>
        </message>
        <message>
            <source>Correct</source>
            <translation>수정</translation>
        </message>
        <message>
            <source>Take out</source>
            <translation>제외</translation>
        </message>
        <message>
            <source>No part chosen</source>
            <translation>선택한 공작물 없음</translation>
        </message>
        <message>
            <source>Touch a row of the table.</source>
            <translation>표의 행을 누르십시오.</translation>
        </message>
        <message>
            <source>Part %1, lot %2</source>
            <translation>공작물 %1, 로트 %2</translation>
        </message>
        <message>
            <source>cut in %1 s</source>
            <translation>가공 %1초</translation>
        </message>
        <message>
            <source>serial %1</source>
            <translation>일련번호 %1</translation>
        </message>
        <message>
            <source>aborted</source>
            <translation>중단됨</translation>
        </message>
        <message>
            <source>process change noticed</source>
            <translation>공정 변화 감지</translation>
        </message>
        <message>
            <source>depth</source>
            <translation>깊이</translation>
        </message>
        <message>
            <source>⌀, %1</source>
            <translation>⌀, %1</translation>
        </message>
        <message>
            <source>by, when</source>
            <translation>작성자, 시각</translation>
        </message>
        <message>
            <source>what, why</source>
            <translation>내용, 사유</translation>
        </message>
        <message>
            <source>correction</source>
            <translation>수정</translation>
        </message>
        <message>
            <source>taken out</source>
            <translation>제외됨</translation>
        </message>
        <message>
            <source>confirmed</source>
            <translation>확인됨</translation>
        </message>
        <message>
            <source>no longer holds</source>
            <translation>더 이상 유효하지 않음</translation>
        </message>
        <message>
            <source>no part chosen</source>
            <translation>선택한 공작물 없음</translation>
        </message>
        <message>
            <source>choose a diameter that holds</source>
            <translation>유효한 지름을 고르십시오</translation>
        </message>
        <message>
            <source>no database</source>
            <translation>데이터베이스 없음</translation>
        </message>
        <message>
            <source>Serial</source>
            <translation>일련번호</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>보고서</translation>
        </message>
        <message>
            <source>%1, part %2</source>
            <translation>%1, 공작물 %2</translation>
        </message>
        <message>
            <source>No course of the feed is kept for this part.</source>
            <translation>이 공작물에는 저장된 이송 기록이 없습니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::PartsModel</name>
        <message>
            <source>finished</source>
            <translation>완료</translation>
        </message>
        <message>
            <source>aborted</source>
            <translation>중단됨</translation>
        </message>
        <message>
            <source>%1 corrected</source>
            <translation>%1개 수정</translation>
        </message>
        <message>
            <source>%1 voided</source>
            <translation>%1개 제외</translation>
        </message>
        <message>
            <source>Part</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>Serial number</source>
            <translation>일련번호</translation>
        </message>
        <message>
            <source>Part type</source>
            <translation>품종</translation>
        </message>
        <message>
            <source>Lot</source>
            <translation>로트</translation>
        </message>
        <message>
            <source>Ended</source>
            <translation>완료 시각</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>결과</translation>
        </message>
        <message>
            <source>Changes</source>
            <translation>변경</translation>
        </message>
        <message>
            <source>Verdict</source>
            <translation>판정</translation>
        </message>
        <message>
            <source>Measured, bores in %1</source>
            <translation>측정값(내경 단위 %1)</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::PartsPage</name>
        <message>
            <source>no lot is open</source>
            <translation>열린 로트 없음</translation>
        </message>
        <message>
            <source>%1 rows written to %2.</source>
            <translation>%1행을 %2에 기록했습니다.</translation>
        </message>
        <message>
            <source>Nothing exported: %1</source>
            <translation>내보내지 못했습니다: %1</translation>
        </message>
        <message>
            <source>This console has no database, so there are no parts to show.</source>
            <translation>이 콘솔에는 데이터베이스가 없어 표시할 공작물이 없습니다.</translation>
        </message>
        <message>
            <source>Search: lot, part type, serial number</source>
            <translation>검색: 로트, 품종, 일련번호</translation>
        </message>
        <message>
            <source>This lot</source>
            <translation>이 로트</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>내보내기</translation>
        </message>
        <message>
            <source>More than %1 parts, newest first</source>
            <translation>공작물 %1개 이상, 최신순</translation>
        </message>
        <message>
            <source>No part matches. Finished parts appear here by themselves.</source>
            <translation>일치하는 공작물이 없습니다. 완료된 공작물은 저절로 나타납니다.</translation>
        </message>
        <message>
            <source>%1 parts, newest first</source>
            <translation>공작물 %1개, 최신순</translation>
        </message>
        <message>
            <source>part %1, %2 deep</source>
            <comment>part number, position</comment>
            <translation>공작물 %1, 깊이 %2</translation>
        </message>
        <message>
            <source>no database</source>
            <translation>데이터베이스 없음</translation>
        </message>
        <message>
            <source>being written</source>
            <translation>기록 중</translation>
        </message>
        <message>
            <source>Export as CSV</source>
            <translation>CSV로 내보내기</translation>
        </message>
        <message>
            <source>All parts that the search shows, oldest first, in mm whatever the screen shows.</source>
            <translation>검색에 나온 모든 공작물을 오래된 순으로, 화면 단위와 관계없이 mm로 기록합니다.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>Measurements</source>
            <translation>측정값</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>이송</translation>
        </message>
        <message>
            <source>Figures</source>
            <translation>수치</translation>
        </message>
        <message>
            <source>Serial number of part %1</source>
            <translation>공작물 %1의 일련번호</translation>
        </message>
        <message>
            <source>Type it or read it with a scanner.</source>
            <translation>입력하거나 스캐너로 읽으십시오.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>The serial number is stored.</source>
            <translation>일련번호를 저장했습니다.</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>저장</translation>
        </message>
        <message>
            <source>Report of part %1</source>
            <translation>공작물 %1의 보고서</translation>
        </message>
        <message>
            <source>One page as PDF, or its measurements as CSV.</source>
            <translation>한 쪽짜리 PDF, 또는 측정값 CSV.</translation>
        </message>
        <message>
            <source>CSV</source>
            <translation>CSV</translation>
        </message>
        <message>
            <source>PDF</source>
            <translation>PDF</translation>
        </message>
        <message>
            <source>Written: %1</source>
            <translation>저장함: %1</translation>
        </message>
        <message>
            <source>Out of tolerance</source>
            <translation>공차 밖</translation>
        </message>
        <message>
            <source>All processes</source>
            <translation>모든 공정</translation>
        </message>
        <message>
            <source>%1 parts out of tolerance among the newest %2</source>
            <translation>최근 %2개 중 공차를 벗어난 공작물 %1개</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ProcessPanel</name>
        <message>
            <source>Cutting process</source>
            <translation>절삭 공정</translation>
        </message>
        <message>
            <source>identified, 95 %</source>
            <translation>식별값, 95 %</translation>
        </message>
        <message>
            <source>law</source>
            <translation>법칙</translation>
        </message>
        <message>
            <source>excitation %1: enough to learn from</source>
            <translation>가진 %1: 배우기에 충분함</translation>
        </message>
        <message>
            <source>excitation %1: too little, the values rest</source>
            <translation>가진 %1: 부족하여 값을 유지함</translation>
        </message>
        <message>
            <source>Identified only with a sensor of the tool's motion; the law assumes its values.</source>
            <translation>공구 운동 센서가 있어야 식별합니다. 법칙은 가정값을 씁니다.</translation>
        </message>
        <message numerus="yes">
            <source>The law was tuned anew %n time(s): the process had moved.</source>
            <translation>
                <numerusform>공정이 변해 법칙을 %n번 다시 맞췄습니다.</numerusform>
            </translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::QualityPage</name>
        <message>
            <source>no part waits for a decision</source>
            <translation>조치를 기다리는 공작물이 없습니다</translation>
        </message>
        <message>
            <source>no lot is shown</source>
            <translation>표시된 로트가 없습니다</translation>
        </message>
        <message>
            <source>the recipe holds the limits of a bore</source>
            <translation>내경의 한계는 레시피에 있습니다</translation>
        </message>
        <message>
            <source>This console has no database, so there is no quality to show.</source>
            <translation>이 콘솔에는 데이터베이스가 없어 표시할 품질이 없습니다.</translation>
        </message>
        <message>
            <source>Decide</source>
            <translation>조치</translation>
        </message>
        <message>
            <source>Gauges</source>
            <translation>게이지</translation>
        </message>
        <message>
            <source>Reports</source>
            <translation>보고서</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>한계</translation>
        </message>
        <message>
            <source>Error against the law</source>
            <translation>법칙 대비 오차</translation>
        </message>
        <message>
            <source>Measured, with tolerance</source>
            <translation>측정값과 공차</translation>
        </message>
        <message>
            <source>What the controller does</source>
            <translation>제어기가 하는 일</translation>
        </message>
        <message>
            <source>Spread</source>
            <translation>산포</translation>
        </message>
        <message>
            <source>%1: lot %2</source>
            <translation>%1: 로트 %2</translation>
        </message>
        <message>
            <source>%1: newest parts</source>
            <translation>%1: 최근 공작물</translation>
        </message>
        <message>
            <source>The lot is being read.</source>
            <translation>로트를 읽는 중입니다.</translation>
        </message>
        <message>
            <source>Choose a lot.</source>
            <translation>로트를 선택하십시오.</translation>
        </message>
        <message>
            <source>%1 good, %2 rework possible, %3 scrap, %4 not judged</source>
            <translation>양품 %1, 재가공 가능 %2, 폐기 %3, 미판정 %4</translation>
        </message>
        <message>
            <source>The estimator takes σ %1 for the gauge: typed in the recipe, not from a study.</source>
            <translation>추정기는 게이지의 σ로 %1을(를) 씁니다. 평가가 아니라 레시피에 입력된 값입니다.</translation>
        </message>
        <message>
            <source>The estimator takes σ %1 for the gauge, from the study of %2 (%3 to %4).</source>
            <translation>추정기는 게이지의 σ로 %2의 평가 결과 %1(%3~%4)을 씁니다.</translation>
        </message>
        <message>
            <source>Gauge %1 is %2.</source>
            <translation>게이지 %1: %2.</translation>
        </message>
        <message>
            <source>Part %1 is out of tolerance: %2</source>
            <translation>%1번 공작물이 공차를 벗어났습니다: %2</translation>
        </message>
        <message>
            <source>What was done with it?</source>
            <translation>어떻게 처리했습니까?</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Not stored: %1</source>
            <translation>저장되지 않음: %1</translation>
        </message>
        <message>
            <source>Cut again</source>
            <translation>다시 절삭</translation>
        </message>
        <message>
            <source>Scrapped</source>
            <translation>폐기함</translation>
        </message>
        <message>
            <source>Accepted under concession</source>
            <translation>특채</translation>
        </message>
        <message>
            <source>these are the first parts</source>
            <translation>처음 공작물입니다</translation>
        </message>
        <message>
            <source>these are the newest parts</source>
            <translation>최신 공작물입니다</translation>
        </message>
        <message>
            <source>Older</source>
            <translation>이전</translation>
        </message>
        <message>
            <source>Newer</source>
            <translation>다음</translation>
        </message>
        <message>
            <source>Older parts</source>
            <translation>이전 공작물</translation>
        </message>
        <message>
            <source>Newer parts</source>
            <translation>다음 공작물</translation>
        </message>
        <message>
            <source>Parts of one tool, person or gauge</source>
            <translation>공구, 작업자 또는 게이지별 공작물</translation>
        </message>
        <message>
            <source>all parts</source>
            <translation>모든 공작물</translation>
        </message>
        <message>
            <source>Parts %1 to %2: %3</source>
            <comment>of a lot that is larger than what is read at once</comment>
            <translation>공작물 %1 ~ %2: %3</translation>
        </message>
        <message>
            <source>%1: all lots</source>
            <translation>%1: 모든 로트</translation>
        </message>
        <message>
            <source>choose one lot</source>
            <translation>로트 하나를 고르십시오</translation>
        </message>
        <message>
            <source>Rules</source>
            <translation>규칙</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::QualitySheets</name>
        <message>
            <source>Written: %1</source>
            <translation>작성됨: %1</translation>
        </message>
        <message>
            <source>Nothing written: %1</source>
            <translation>작성되지 않음: %1</translation>
        </message>
        <message>
            <source>Report and files of the lot</source>
            <translation>로트의 보고서와 파일</translation>
        </message>
        <message>
            <source>A report is a PDF with the values attached as Q-DAS file and CSV.</source>
            <translation>보고서는 값을 Q-DAS 파일과 CSV로 첨부한 PDF입니다.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>Lot report</source>
            <translation>로트 보고서</translation>
        </message>
        <message>
            <source>First article</source>
            <translation>초품 검사</translation>
        </message>
        <message>
            <source>Q-DAS file</source>
            <translation>Q-DAS 파일</translation>
        </message>
        <message>
            <source>Automatic files</source>
            <translation>자동 파일</translation>
        </message>
        <message>
            <source>Q-DAS files by themselves</source>
            <translation>자동 Q-DAS 파일</translation>
        </message>
        <message>
            <source>Each part gets a file in this folder once it is judged. Without a folder there are no files. Names may hold {type}, {lot}, {part}, {serial}, {machine}, {date} and {time}.</source>
            <translation>공작물이 판정되면 이 폴더에 파일이 하나씩 생깁니다. 폴더가 없으면 파일도 없습니다. 이름에는 {type}, {lot}, {part}, {serial}, {machine}, {date}, {time}을 쓸 수 있습니다.</translation>
        </message>
        <message>
            <source>Folder</source>
            <translation>폴더</translation>
        </message>
        <message>
            <source>File name</source>
            <translation>파일 이름</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>저장</translation>
        </message>
        <message>
            <source>Rules of the charts</source>
            <translation>관리도 규칙</translation>
        </message>
        <message>
            <source>What a rule finds becomes a signal and an alarm. Each one more alarms wrongly more often: Nelson 1 with the EWMA once in about 400 parts of a steady lot, all eight of Nelson once in about 100.</source>
            <translation>규칙이 찾아낸 것은 신호와 알람이 됩니다. 규칙이 많을수록 잘못된 알람이 잦아집니다. 안정된 로트에서 Nelson 1과 EWMA는 공작물 약 400개에 한 번, Nelson 규칙 8개 모두는 약 100개에 한 번 잘못 울립니다.</translation>
        </message>
        <message>
            <source>Default set</source>
            <translation>기본 규칙</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::RawChart</name>
        <message>
            <source>part</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>The measured values of the lot appear here.</source>
            <translation>로트의 측정값이 여기에 표시됩니다.</translation>
        </message>
        <message>
            <source>Measured values with their tolerance</source>
            <translation>측정값과 공차</translation>
        </message>
        <message>
            <source>upper</source>
            <translation>상한</translation>
        </message>
        <message>
            <source>lower</source>
            <translation>하한</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::RecipeForm</name>
        <message>
            <source>at most %1 depths</source>
            <translation>깊이는 최대 %1곳</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>삭제</translation>
        </message>
        <message>
            <source>Depth %1, overhang</source>
            <translation>깊이 %1, 돌출 길이</translation>
        </message>
        <message>
            <source>%1: %2 → %3</source>
            <comment>name of a number, newest revision, shown</comment>
            <translation>%1: %2 → %3</translation>
        </message>
        <message>
            <source>Depth %1</source>
            <translation>깊이 %1</translation>
        </message>
        <message>
            <source>Against revision %1:</source>
            <translation>개정 %1과(와) 비교:</translation>
        </message>
        <message>
            <source>As revision %1, the newest.</source>
            <translation>최신 개정 %1과(와) 같음.</translation>
        </message>
        <message>
            <source>A number is missing or out of its range.</source>
            <translation>빠졌거나 범위를 벗어난 숫자가 있습니다.</translation>
        </message>
        <message>
            <source>Lots that are open keep their own revision.</source>
            <translation>열려 있는 로트는 자기 개정을 유지합니다.</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>저장 중</translation>
        </message>
        <message>
            <source>sign on first</source>
            <translation>먼저 로그인하십시오</translation>
        </message>
        <message>
            <source>a number does not fit</source>
            <translation>맞지 않는 숫자가 있음</translation>
        </message>
        <message>
            <source>a part type needs a name</source>
            <translation>품종 이름이 필요함</translation>
        </message>
        <message>
            <source>nothing is changed</source>
            <translation>바뀐 것이 없음</translation>
        </message>
        <message>
            <source>give a reason</source>
            <translation>사유를 쓰십시오</translation>
        </message>
        <message>
            <source>touch an older revision</source>
            <translation>이전 개정을 누르십시오</translation>
        </message>
        <message>
            <source>The recipe has a new revision.</source>
            <translation>레시피의 새 개정을 저장했습니다.</translation>
        </message>
        <message>
            <source>The part type is there.</source>
            <translation>품종을 만들었습니다.</translation>
        </message>
        <message>
            <source>Revision %1 is back.</source>
            <translation>개정 %1(으)로 되돌렸습니다.</translation>
        </message>
        <message>
            <source>Recipe of %1</source>
            <translation>%1의 레시피</translation>
        </message>
        <message>
            <source>New part type</source>
            <translation>새 품종</translation>
        </message>
        <message>
            <source>%1 to %2; default %3, %4</source>
            <comment>range, default, source of the default</comment>
            <translation>%1~%2, 기본값 %3, %4</translation>
        </message>
        <message>
            <source>Name of the part type</source>
            <translation>품종 이름</translation>
        </message>
        <message>
            <source>Reason for the change</source>
            <translation>변경 사유</translation>
        </message>
        <message>
            <source>Depths, in measuring order</source>
            <translation>깊이(측정 순서대로)</translation>
        </message>
        <message>
            <source>Add a depth</source>
            <translation>깊이 추가</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>뒤로</translation>
        </message>
        <message>
            <source>Roll back to it</source>
            <translation>이 개정으로 되돌리기</translation>
        </message>
        <message>
            <source>Save as a new revision</source>
            <translation>새 개정으로 저장</translation>
        </message>
        <message>
            <source>Make the part type</source>
            <translation>품종 만들기</translation>
        </message>
        <message>
            <source>Rev.</source>
            <translation>개정</translation>
        </message>
        <message>
            <source>When, by</source>
            <translation>언제, 누가</translation>
        </message>
        <message>
            <source>Why</source>
            <translation>사유</translation>
        </message>
        <message>
            <source>back to %1: %2</source>
            <comment>revision, reason</comment>
            <translation>%1(으)로 되돌림: %2</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::RecoverySheet</name>
        <message>
            <source>the tap is turning out</source>
            <translation>탭을 빼내는 중</translation>
        </message>
        <message>
            <source>the tap is out</source>
            <translation>탭이 빠졌음</translation>
        </message>
        <message>
            <source>switch tapping to control</source>
            <translation>탭 루프를 제어로 전환</translation>
        </message>
        <message>
            <source>A tap stands in the hole</source>
            <translation>탭이 구멍에 멈춰 있음</translation>
        </message>
        <message>
            <source>Where: %1 revolutions in, %2 deep; the spindle stands %3° after a whole turn. Both are stored.</source>
            <translation>위치: %1회전 진입, 깊이 %2; 주축은 정회전 후 %3°에 있습니다. 둘 다 저장되어 있습니다.</translation>
        </message>
        <message>
            <source>What will happen: the accepted gains are set, then the spindle turns back %1 revolutions and Z follows it at %2 per revolution until the tap is out. No other axis moves. Do not jog Z or the spindle alone: it breaks the tap.</source>
            <translation>진행: 수락된 게인을 설정한 뒤 주축이 %1회전 되돌고 Z가 회전당 %2로 따라가 탭이 빠집니다. 다른 축은 움직이지 않습니다. Z나 주축만 따로 움직이지 마십시오: 탭이 부러집니다.</translation>
        </message>
        <message>
            <source>Ready. Keep a hand at the emergency stop.</source>
            <translation>준비됨. 비상정지에 손을 두십시오.</translation>
        </message>
        <message>
            <source>Not ready: %1.</source>
            <translation>준비 안 됨: %1.</translation>
        </message>
        <message>
            <source>Turning out: %1 revolutions to go.</source>
            <translation>빼내는 중: %1회전 남음.</translation>
        </message>
        <message>
            <source>The tap is out. Gauge the thread and look at the tap before the next one.</source>
            <translation>탭이 빠졌습니다. 다음 탭 전에 나사를 게이지로 확인하고 탭을 살펴보십시오.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>Leave it in the hole</source>
            <translation>구멍에 두기</translation>
        </message>
        <message>
            <source>Turn out in sync</source>
            <translation>동기하여 빼내기</translation>
        </message>
        <message>
            <source>The tap is gone</source>
            <translation>탭이 없어졌음</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ResidualChart</name>
        <message>
            <source>part</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>error against the law, σ</source>
            <translation>법칙 대비 오차, σ</translation>
        </message>
        <message>
            <source>The error of each part against the law's prediction appears here from the second part on.</source>
            <translation>두 번째 공작물부터 법칙의 예측 대비 오차가 여기에 표시됩니다.</translation>
        </message>
        <message>
            <source>EWMA</source>
            <translation>EWMA</translation>
        </message>
        <message>
            <source>One-step errors</source>
            <translation>1단계 오차</translation>
        </message>
        <message>
            <source>signal</source>
            <translation>신호</translation>
        </message>
        <message>
            <source>EWMA limit</source>
            <translation>EWMA 한계</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SensorsPage</name>
        <message>
            <source>touch a channel first</source>
            <translation>먼저 채널을 누르십시오</translation>
        </message>
        <message>
            <source>no gauge that can be asked is connected</source>
            <translation>물어볼 수 있는 게이지가 연결되어 있지 않습니다</translation>
        </message>
        <message>
            <source>This console was started without a sensor file (--sensors): only what the machine itself brings is read.</source>
            <translation>이 콘솔은 센서 파일(--sensors) 없이 시작되었습니다. 기계 자체의 신호만 읽습니다.</translation>
        </message>
        <message>
            <source>Sensors and gauges</source>
            <translation>센서와 게이지</translation>
        </message>
        <message>
            <source>Where they sit</source>
            <translation>센서 위치</translation>
        </message>
        <message>
            <source>Channel</source>
            <translation>채널</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>위치</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>값</translation>
        </message>
        <message>
            <source>Age</source>
            <translation>경과</translation>
        </message>
        <message>
            <source>State</source>
            <translation>상태</translation>
        </message>
        <message>
            <source>Module, gauge</source>
            <translation>모듈, 게이지</translation>
        </message>
        <message>
            <source>Address</source>
            <translation>주소</translation>
        </message>
        <message>
            <source>Reads</source>
            <translation>읽음</translation>
        </message>
        <message>
            <source>Place on the picture</source>
            <translation>그림에 놓기</translation>
        </message>
        <message>
            <source>Test read of the gauges</source>
            <translation>게이지 시험 읽기</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1초</translation>
        </message>
        <message>
            <source>good</source>
            <translation>정상</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%2개 중 %1개</translation>
        </message>
        <message>
            <source>not plugged in</source>
            <translation>꽂혀 있지 않음</translation>
        </message>
        <message>
            <source>connected</source>
            <translation>연결됨</translation>
        </message>
        <message>
            <source>Stop looking</source>
            <translation>찾기 중지</translation>
        </message>
        <message>
            <source>Which one rises?</source>
            <translation>어느 것이 올라갑니까?</translation>
        </message>
        <message>
            <source>The reading process does not answer; it is started again.</source>
            <translation>읽기 프로세스가 응답하지 않습니다. 다시 시작합니다.</translation>
        </message>
        <message>
            <source>Touch the picture where %1 sits.</source>
            <translation>그림에서 %1의 위치를 누르십시오.</translation>
        </message>
        <message>
            <source>It is %1: %2 warmer.</source>
            <translation>%1입니다: %2 올라갔습니다.</translation>
        </message>
        <message>
            <source>Warm one thermocouple with a finger; its channel shows itself.</source>
            <translation>열전대 하나를 손가락으로 데우십시오. 해당 채널이 나타납니다.</translation>
        </message>
        <message>
            <source>A picture of this machine (PNG) in %1 is shown here.</source>
            <translation>%1 폴더에 이 기계의 사진(PNG)을 넣으면 여기에 표시됩니다.</translation>
        </message>
        <message>
            <source>Touch a channel, then its place on the picture.</source>
            <translation>채널을 누른 다음 그림에서 위치를 누르십시오.</translation>
        </message>
        <message>
            <source>Sensor file and modules</source>
            <translation>센서 파일과 모듈</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>%1: no reading</source>
            <translation>%1: 측정값이 아님</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::Sheet</name>
        <message>
            <source>That is stored. What was typed since then is not yet.</source>
            <translation>저장되었습니다. 그 뒤에 입력한 것은 아직 저장되지 않았습니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SheetHost</name>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ShiftPage</name>
        <message>
            <source>this shift has been handed over</source>
            <translation>이미 인계한 근무조입니다</translation>
        </message>
        <message>
            <source>No data file is open: a shift is what is stored between two handovers.</source>
            <translation>열린 데이터 파일이 없습니다. 근무조는 두 인계 사이에 저장된 기록입니다.</translation>
        </message>
        <message>
            <source>Parts</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>Stops: touch one and say why</source>
            <translation>정지: 눌러서 사유를 고르십시오</translation>
        </message>
        <message>
            <source>Notes and handover</source>
            <translation>메모와 인계</translation>
        </message>
        <message>
            <source>Changes</source>
            <translation>변경</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>알람</translation>
        </message>
        <message>
            <source>◀ Shift before</source>
            <translation>◀ 이전 근무조</translation>
        </message>
        <message>
            <source>This shift</source>
            <translation>이번 근무조</translation>
        </message>
        <message>
            <source>One page (PDF)</source>
            <translation>한 장 보고서 (PDF)</translation>
        </message>
        <message>
            <source>Leave a note</source>
            <translation>메모 남기기</translation>
        </message>
        <message>
            <source>Hand over</source>
            <translation>인계</translation>
        </message>
        <message>
            <source>Shift from %1 to %2</source>
            <translation>근무조 %1 – %2</translation>
        </message>
        <message>
            <source>The last twelve hours; a shift begins when one is handed over.</source>
            <translation>최근 12시간입니다. 인계하면 새 근무조가 시작됩니다.</translation>
        </message>
        <message>
            <source>This shift, taken over from %2 at %1</source>
            <translation>이번 근무조: %1, %2에게서 인수</translation>
        </message>
        <message>
            <source>No part was finished.</source>
            <translation>완료된 공작물이 없습니다.</translation>
        </message>
        <message>
            <source>since %1</source>
            <translation>%1부터</translation>
        </message>
        <message>
            <source>%1 min</source>
            <translation>%1분</translation>
        </message>
        <message>
            <source>Nothing stood longer than three minutes.</source>
            <translation>3분을 넘는 정지가 없습니다.</translation>
        </message>
        <message>
            <source>Handover: %1</source>
            <translation>인계: %1</translation>
        </message>
        <message>
            <source>No note was left.</source>
            <translation>남긴 메모가 없습니다.</translation>
        </message>
        <message>
            <source>Nothing was changed.</source>
            <translation>변경 사항이 없습니다.</translation>
        </message>
        <message>
            <source>No alarm came.</source>
            <translation>알람이 없었습니다.</translation>
        </message>
        <message>
            <source>Why did nothing run?</source>
            <translation>왜 멈췄습니까?</translation>
        </message>
        <message>
            <source>The reason is kept.</source>
            <translation>사유를 저장했습니다.</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Hand over the shift</source>
            <translation>근무조 인계</translation>
        </message>
        <message>
            <source>A note for the next shift</source>
            <translation>다음 근무조에 남기는 메모</translation>
        </message>
        <message>
            <source>It is signed by %1. The next shift begins now.</source>
            <translation>%1 이름으로 서명합니다. 지금부터 다음 근무조입니다.</translation>
        </message>
        <message>
            <source>What the next one has to know</source>
            <translation>다음 사람이 알아야 할 것</translation>
        </message>
        <message>
            <source>Sign and hand over</source>
            <translation>서명하고 인계</translation>
        </message>
        <message>
            <source>Keep the note</source>
            <translation>메모 저장</translation>
        </message>
        <message>
            <source>The shift is handed over.</source>
            <translation>근무조를 인계했습니다.</translation>
        </message>
        <message>
            <source>The note is kept.</source>
            <translation>메모를 저장했습니다.</translation>
        </message>
        <message>
            <source>Where to</source>
            <translation>저장할 곳</translation>
        </message>
        <message>
            <source>A file that is there already is never written over.</source>
            <translation>이미 있는 파일은 덮어쓰지 않습니다.</translation>
        </message>
        <message>
            <source>shift</source>
            <comment>file name</comment>
            <translation>근무조</translation>
        </message>
        <message>
            <source>Written: %1</source>
            <translation>저장했습니다: %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SpectrumChart</name>
        <message>
            <source>amplitude</source>
            <translation>진폭</translation>
        </message>
        <message>
            <source>without the trim</source>
            <translation>보정 없이</translation>
        </message>
        <message>
            <source>predicted surface</source>
            <translation>예측 표면</translation>
        </message>
        <message>
            <source>The spectrum of the surface appears here after two seconds of cutting.</source>
            <translation>2초 절삭하면 여기에 표면의 스펙트럼이 나타납니다.</translation>
        </message>
        <message>
            <source>Spectrum of the predicted surface</source>
            <translation>예측 표면의 스펙트럼</translation>
        </message>
        <message>
            <source>amplitude, %1, over frequency, Hz</source>
            <comment>unit</comment>
            <translation>진폭, %1 / 주파수, Hz</translation>
        </message>
        <message>
            <source>%1 blind</source>
            <comment>frequency in Hz</comment>
            <translation>%1 안 보임</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SpeedChart</name>
        <message>
            <source>error p-p</source>
            <translation>오차 p-p</translation>
        </message>
        <message>
            <source>Each speed that has been tuned stands here as a point: error against time per hole.</source>
            <translation>튜닝한 속도마다 점 하나가 나타납니다: 구멍당 시간에 대한 오차.</translation>
        </message>
        <message>
            <source>Sync error against time per hole, by speed</source>
            <translation>속도별 구멍당 시간에 대한 동기 오차</translation>
        </message>
        <message>
            <source>allowed</source>
            <translation>허용</translation>
        </message>
        <message>
            <source>%1 rpm</source>
            <translation>%1 rpm</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SpreadChart</name>
        <message>
            <source>parts</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>How the values lie in their tolerance appears here.</source>
            <translation>값이 공차 안에 어떻게 놓이는지 여기에 표시됩니다.</translation>
        </message>
        <message>
            <source>Histogram with tolerance</source>
            <translation>공차가 있는 히스토그램</translation>
        </message>
        <message>
            <source>lower</source>
            <translation>하한</translation>
        </message>
        <message>
            <source>upper</source>
            <translation>상한</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::SurfacePanel</name>
        <message>
            <source>Surface as the force shows it</source>
            <translation>힘으로 본 표면</translation>
        </message>
        <message>
            <source>No tone of this machine is known.</source>
            <translation>이 기계의 진동 주파수를 아직 모릅니다.</translation>
        </message>
        <message>
            <source>At %1 the force sees every known tone.</source>
            <translation>%1에서는 알려진 진동 주파수가 모두 힘에 보입니다.</translation>
        </message>
        <message>
            <source>At %1 the force is blind to %2 Hz: such a tone repeats with every revolution.</source>
            <translation>%1에서는 힘이 %2 Hz를 보지 못합니다. 회전마다 되풀이되는 주파수입니다.</translation>
        </message>
        <message>
            <source>Use %1</source>
            <translation>%1 사용</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TapActions</name>
        <message>
            <source>a tuning is under way</source>
            <translation>튜닝 진행 중</translation>
        </message>
        <message>
            <source>nothing to accept</source>
            <translation>수락할 것 없음</translation>
        </message>
        <message>
            <source>Job…</source>
            <translation>작업…</translation>
        </message>
        <message>
            <source>Tune</source>
            <translation>튜닝</translation>
        </message>
        <message>
            <source>One more</source>
            <translation>한 번 더</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>수락</translation>
        </message>
        <message>
            <source>Roll back</source>
            <translation>되돌리기</translation>
        </message>
        <message>
            <source>Automatic</source>
            <translation>자동</translation>
        </message>
        <message>
            <source>Abort the tap</source>
            <translation>탭 중단</translation>
        </message>
        <message>
            <source>Turn the tap out…</source>
            <translation>탭 빼내기…</translation>
        </message>
        <message>
            <source>No job is loaded</source>
            <translation>로드된 작업 없음</translation>
        </message>
        <message>
            <source>Tap</source>
            <translation>탭 가공</translation>
        </message>
        <message>
            <source>Air tap</source>
            <translation>에어 탭</translation>
        </message>
        <message>
            <source>a tap stands in the hole</source>
            <translation>탭이 구멍에 있음</translation>
        </message>
        <message>
            <source>a tap is under way</source>
            <translation>탭 진행 중</translation>
        </message>
        <message>
            <source>this machine has no tapping loop</source>
            <translation>이 기계에 탭 루프 없음</translation>
        </message>
        <message>
            <source>switch to control</source>
            <translation>제어로 전환</translation>
        </message>
        <message>
            <source>no job is loaded</source>
            <translation>로드된 작업 없음</translation>
        </message>
        <message>
            <source>no proposal yet</source>
            <translation>아직 제안 없음</translation>
        </message>
        <message>
            <source>all taps are used</source>
            <translation>탭을 모두 사용함</translation>
        </message>
        <message>
            <source>nothing to roll back</source>
            <translation>되돌릴 것 없음</translation>
        </message>
        <message>
            <source>the tap is being turned out</source>
            <translation>탭을 빼내는 중</translation>
        </message>
        <message>
            <source>no tap is running</source>
            <translation>실행 중인 탭 없음</translation>
        </message>
        <message>
            <source>the loop is off: abort at the control</source>
            <translation>루프 꺼짐: 제어기에서 중단</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TappingPage</name>
        <message>
            <source>Load this point?</source>
            <translation>이 점을 로드할까요?</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>취소</translation>
        </message>
        <message>
            <source>Load</source>
            <translation>로드</translation>
        </message>
        <message>
            <source>This machine does not tap with Kerf. The page fills when its tapping loop is fitted.</source>
            <translation>이 기계는 Kerf로 탭 가공을 하지 않습니다. 탭 루프가 장착되면 이 페이지가 채워집니다.</translation>
        </message>
        <message>
            <source>Trial taps</source>
            <translation>시험 탭</translation>
        </message>
        <message>
            <source>Error p-p, %1, over time per hole</source>
            <comment>unit</comment>
            <translation>구멍당 시간별 오차 p-p, %1</translation>
        </message>
        <message>
            <source>%1 rev, error %2</source>
            <translation>%1회전, 오차 %2</translation>
        </message>
        <message>
            <source>A tap stands %1 revolutions (%2) in the hole. Turn it out in sync before anything else moves.</source>
            <translation>탭이 구멍에 %1회전(%2) 들어가 있습니다. 다른 것이 움직이기 전에 동기하여 빼내십시오.</translation>
        </message>
        <message>
            <source>No tap was made: %1</source>
            <translation>탭을 하지 않았습니다: %1</translation>
        </message>
        <message>
            <source>The tuning could not be stored: %1</source>
            <translation>튜닝을 저장하지 못했습니다: %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ThermalPage</name>
        <message>
            <source>This machine reports no temperatures. The page fills as soon as it does.</source>
            <translation>이 기계는 온도를 알려 주지 않습니다. 온도가 오면 화면이 채워집니다.</translation>
        </message>
        <message>
            <source>Drift over time, %1</source>
            <translation>시간에 따른 열변위, %1</translation>
        </message>
        <message>
            <source>The predicted drift appears here one minute after the reference, as soon as a model is live.</source>
            <translation>모델이 적용되면 기준을 잡고 1분 뒤 예측 열변위가 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>Temperatures</source>
            <translation>온도</translation>
        </message>
        <message>
            <source>Warm up</source>
            <translation>예열</translation>
        </message>
        <message>
            <source>Measure</source>
            <translation>측정</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>모델</translation>
        </message>
        <message>
            <source>History</source>
            <translation>이력</translation>
        </message>
        <message>
            <source>Sensors</source>
            <translation>센서</translation>
        </message>
        <message>
            <source>Error map</source>
            <translation>오차 지도</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>한계</translation>
        </message>
        <message>
            <source>Stop warm-up</source>
            <translation>예열 중지</translation>
        </message>
        <message>
            <source>Nothing can be stored at the moment: %1</source>
            <translation>지금은 저장할 수 없습니다: %1</translation>
        </message>
        <message>
            <source>No temperatures yet.</source>
            <translation>아직 온도가 없습니다.</translation>
        </message>
        <message numerus="yes">
            <source>%n thermocouples give no reading.</source>
            <translation>
                <numerusform>열전대 %n개가 읽히지 않습니다.</numerusform>
            </translation>
        </message>
        <message>
            <source>Left out: %1</source>
            <translation>제외: %1</translation>
        </message>
        <message>
            <source>All %1 thermocouples are healthy; filled points belong to the model.</source>
            <translation>열전대 %1개가 모두 정상입니다. 채운 점이 모델이 쓰는 것입니다.</translation>
        </message>
        <message>
            <source>Touch a point to read it.</source>
            <translation>점을 누르면 값이 나옵니다.</translation>
        </message>
        <message>
            <source>%1: %2, %3; %4 in 10 min</source>
            <comment>sensor, temperature, state, change</comment>
            <translation>%1: %2, %3, 10분 동안 %4</translation>
        </message>
        <message>
            <source>Warm up the spindle?</source>
            <translation>주축을 예열할까요?</translation>
        </message>
        <message>
            <source>The spindle turns at %1 for %2. Take care that nothing is in its way.</source>
            <translation>주축이 %1로 %2 동안 돕니다. 주위에 걸리는 것이 없는지 확인하십시오.</translation>
        </message>
        <message>
            <source>Not now</source>
            <translation>나중에</translation>
        </message>
        <message>
            <source>Start the spindle</source>
            <translation>주축 시작</translation>
        </message>
        <message>
            <source>time</source>
            <translation>시간</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TouchKeyboard</name>
        <message>
            <source>ABC</source>
            <translation>가나다</translation>
        </message>
        <message>
            <source>Space</source>
            <translation>띄어쓰기</translation>
        </message>
        <message>
            <source>Enter</source>
            <translation>입력</translation>
        </message>
        <message>
            <source>Hide the keyboard</source>
            <translation>키보드 숨기기</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TrialBars</name>
        <message>
            <source>before</source>
            <translation>전</translation>
        </message>
        <message>
            <source>after</source>
            <translation>후</translation>
        </message>
        <message>
            <source>One bar per trial tap appears here.</source>
            <translation>시험 탭마다 막대 하나가 여기에 나타납니다.</translation>
        </message>
        <message>
            <source>allowed %1</source>
            <translation>허용 %1</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TurningArchive</name>
        <message>
            <source>Archive of turned parts</source>
            <translation>선삭 공작물 보관함</translation>
        </message>
        <message>
            <source>Touch a part to see its spectrum and its force along the face.</source>
            <translation>공작물을 누르면 스펙트럼과 면을 따른 힘이 보입니다.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>닫기</translation>
        </message>
        <message>
            <source>force, %1, along the face, %</source>
            <comment>unit</comment>
            <translation>힘, %1 / 면을 따라, %</translation>
        </message>
        <message>
            <source>force</source>
            <translation>힘</translation>
        </message>
        <message>
            <source>This part has no force trace.</source>
            <translation>이 공작물에는 힘 기록이 없습니다.</translation>
        </message>
        <message>
            <source>Force along the face</source>
            <translation>면을 따른 힘</translation>
        </message>
        <message>
            <source>part</source>
            <translation>공작물</translation>
        </message>
        <message>
            <source>ended</source>
            <translation>종료</translation>
        </message>
        <message>
            <source>controller</source>
            <translation>제어기</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>RMS</translation>
        </message>
        <message>
            <source>P-V</source>
            <translation>P-V</translation>
        </message>
        <message>
            <source>open</source>
            <comment>surface without the trim</comment>
            <translation>개루프</translation>
        </message>
        <message>
            <source>mean force</source>
            <translation>평균 힘</translation>
        </message>
        <message>
            <source>left the loop</source>
            <translation>루프에서 빠짐</translation>
        </message>
        <message>
            <source>no control</source>
            <translation>제어 없음</translation>
        </message>
        <message>
            <source>Part %1: %2. Touched at %3, zero %4, largest trim %5.</source>
            <translation>공작물 %1: %2. 터치오프 %3, 영점 %4, 최대 보정 %5.</translation>
        </message>
        <message>
            <source>a₁ %1, b₀ %2, b₁ %3.</source>
            <translation>a₁ %1, b₀ %2, b₁ %3.</translation>
        </message>
        <message>
            <source>It was not cut to the end.</source>
            <translation>끝까지 절삭하지 않았습니다.</translation>
        </message>
        <message>
            <source>target</source>
            <translation>목표</translation>
        </message>
        <message>
            <source>Reason to leave this part out of what the next ones begin from</source>
            <translation>이 공작물을 다음 공작물이 시작하는 근거에서 빼는 이유</translation>
        </message>
        <message>
            <source>Left out by %1: %2</source>
            <translation>%1 님이 뺌: %2</translation>
        </message>
        <message>
            <source>The first part after a start begins from the assumed process: none of this cut is sure.</source>
            <translation>시작 뒤 첫 공작물은 가정한 공정에서 시작합니다. 이 절삭에는 확실한 공작물이 없습니다.</translation>
        </message>
        <message>
            <source>The first part after a start begins from part %1; parts of this cut that count: %2.</source>
            <translation>시작 뒤 첫 공작물은 공작물 %1에서 시작합니다. 이 절삭에서 세는 공작물: %2.</translation>
        </message>
        <message>
            <source>The first part after a start begins from the assumed process: the parts of this cut contradict each other.</source>
            <translation>시작 뒤 첫 공작물은 가정한 공정에서 시작합니다. 이 절삭의 공작물들이 서로 어긋납니다.</translation>
        </message>
        <message>
            <source>Take in again</source>
            <translation>다시 넣기</translation>
        </message>
        <message>
            <source>Leave out</source>
            <translation>빼기</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TurningControlPanel</name>
        <message>
            <source>controller</source>
            <translation>제어기</translation>
        </message>
        <message>
            <source>Start part</source>
            <translation>공작물 시작</translation>
        </message>
        <message>
            <source>Setup</source>
            <translation>설정</translation>
        </message>
        <message>
            <source>Next part: %1. Overlap factor %2.</source>
            <translation>다음 공작물: %1. 중첩 계수 %2.</translation>
        </message>
        <message>
            <source>Nothing can be stored at the moment: %1</source>
            <translation>지금은 저장할 수 없습니다: %1</translation>
        </message>
        <message>
            <source>Diamond turning: %1</source>
            <comment>stage</comment>
            <translation>다이아몬드 선삭: %1</translation>
        </message>
        <message>
            <source>This machine has no turning loop: %1</source>
            <translation>이 기계에는 선삭 루프가 없습니다: %1</translation>
        </message>
        <message>
            <source>This machine has no turning loop.</source>
            <translation>이 기계에는 선삭 루프가 없습니다.</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TurningPage</name>
        <message>
            <source>This machine has no turning loop: force feedback needs a lathe with a 0.2 ms cycle, a force sensor and a fast tool trim.</source>
            <translation>이 기계에는 선삭 루프가 없습니다. 힘 피드백에는 0.2 ms 주기의 선반, 힘 센서, 빠른 공구 보정이 필요합니다.</translation>
        </message>
        <message>
            <source>Predicted surface, RMS</source>
            <translation>예측 표면, RMS</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::TurningSetupForm</name>
        <message>
            <source>Setup of the next part</source>
            <translation>다음 공작물의 설정</translation>
        </message>
        <message>
            <source>A part being cut keeps the setup it began with.</source>
            <translation>절삭 중인 공작물은 시작할 때의 설정을 유지합니다.</translation>
        </message>
        <message>
            <source>Cut</source>
            <translation>절삭</translation>
        </message>
        <message>
            <source>Tones of the machine</source>
            <translation>기계의 진동 주파수</translation>
        </message>
        <message>
            <source>Leave as it is</source>
            <translation>그대로 두기</translation>
        </message>
        <message>
            <source>Use for the next part</source>
            <translation>다음 공작물에 사용</translation>
        </message>
        <message>
            <source>Tone %1</source>
            <translation>주파수 %1</translation>
        </message>
        <message>
            <source>being stored</source>
            <translation>저장하는 중</translation>
        </message>
        <message>
            <source>a value is missing</source>
            <translation>값이 빠졌습니다</translation>
        </message>
        <message>
            <source>a tone is out of range</source>
            <translation>범위를 벗어난 주파수가 있습니다</translation>
        </message>
        <message>
            <source>Overlap factor %1</source>
            <translation>중첩 계수 %1</translation>
        </message>
        <message>
            <source>Not stored: %1</source>
            <translation>저장되지 않음: %1</translation>
        </message>
        <message>
            <source>The next part is cut with the new setup.</source>
            <translation>다음 공작물은 새 설정으로 절삭합니다.</translation>
        </message>
        <message>
            <source>Reason, when a limit is raised</source>
            <translation>한계를 올릴 때의 사유</translation>
        </message>
    </context>
    <context>
    <name>kerf::ui::ValueField</name>
        <message>
            <source>Enter a number.</source>
            <translation>숫자를 입력하십시오.</translation>
        </message>
        <message>
            <source>“%1” is not a number.</source>
            <translation>“%1”은(는) 숫자가 아닙니다.</translation>
        </message>
        <message>
            <source>Must be from %1 to %2.</source>
            <translation>%1에서 %2 사이여야 합니다.</translation>
        </message>
    </context>
<context>
    <name>kerf::ui::SensorSetupPanel</name>
        <message>
            <source>none is chosen</source>
            <translation>선택한 파일이 없습니다</translation>
        </message>
        <message>
            <source>being asked: units 1 to 32</source>
            <translation>묻는 중: 유닛 1~32</translation>
        </message>
        <message>
            <source>enter its address first</source>
            <translation>먼저 주소를 입력하십시오</translation>
        </message>
        <message>
            <source>Sensor file</source>
            <translation>센서 파일</translation>
        </message>
        <message>
            <source>What answers at an address</source>
            <translation>주소에서 응답하는 것</translation>
        </message>
        <message>
            <source>Address of a temperature module (Modbus TCP), with its port where that is not 502. It is only read. What a module has in its registers says which channel is which.</source>
            <translation>온도 모듈(Modbus TCP)의 주소입니다. 포트가 502가 아니면 포트도 적으십시오. 읽기만 합니다. 레지스터 값을 보면 어느 채널인지 알 수 있습니다.</translation>
        </message>
        <message>
            <source>Use this file from the next start</source>
            <translation>다음 시작부터 이 파일 사용</translation>
        </message>
        <message>
            <source>Use none</source>
            <translation>사용 안 함</translation>
        </message>
        <message>
            <source>Look again</source>
            <translation>다시 찾기</translation>
        </message>
        <message>
            <source>Ask what is there</source>
            <translation>무엇이 있는지 묻기</translation>
        </message>
        <message>
            <source>File</source>
            <translation>파일</translation>
        </message>
        <message>
            <source>What is in it</source>
            <translation>내용</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>유닛</translation>
        </message>
        <message>
            <source>Module</source>
            <translation>모듈</translation>
        </message>
        <message>
            <source>First registers</source>
            <translation>첫 레지스터</translation>
        </message>
        <message>
            <source>In use: %1. It was named at the start (--sensors), so it stays.</source>
            <translation>사용 중: %1. 시작할 때 지정했으므로(--sensors) 그대로입니다.</translation>
        </message>
        <message>
            <source>In use: %1.</source>
            <translation>사용 중: %1.</translation>
        </message>
        <message>
            <source>In use: %1. From the next start none is used.</source>
            <translation>사용 중: %1. 다음 시작부터는 사용하지 않습니다.</translation>
        </message>
        <message>
            <source>In use: %1. From the next start: %2.</source>
            <translation>사용 중: %1. 다음 시작부터: %2.</translation>
        </message>
        <message>
            <source>From the next start: %1. Until then only what the machine itself brings is read.</source>
            <translation>다음 시작부터: %1. 그때까지는 기계가 직접 주는 값만 읽습니다.</translation>
        </message>
        <message>
            <source>None is in use: only what the machine itself brings is read.</source>
            <translation>사용 중인 파일이 없습니다. 기계가 직접 주는 값만 읽습니다.</translation>
        </message>
        <message>
            <source>modules: %1, channels: %2, gauges: %3</source>
            <translation>모듈 %1개, 채널 %2개, 게이지 %3개</translation>
        </message>
        <message>
            <source>cannot be used: %1</source>
            <translation>쓸 수 없음: %1</translation>
        </message>
        <message>
            <source>%1 is asked; that takes up to 20 s.</source>
            <translation>%1에 묻고 있습니다. 최대 20초 걸립니다.</translation>
        </message>
        <message>
            <source>%1 takes a connection, but no unit from 1 to 32 answers.</source>
            <translation>%1에 연결은 되지만 1번부터 32번까지 응답하는 유닛이 없습니다.</translation>
        </message>
        <message>
            <source>%1 answers; register numbers are as on the wire, from 0.</source>
            <translation>%1이(가) 응답합니다. 레지스터 번호는 통신상의 번호로 0부터입니다.</translation>
        </message>
        <message>
            <source>no sensor file is there yet</source>
            <translation>센서 파일이 아직 없습니다</translation>
        </message>
        <message>
            <source>touch a file first</source>
            <translation>먼저 파일을 누르십시오</translation>
        </message>
        <message>
            <source>this one cannot be used</source>
            <translation>이 파일은 쓸 수 없습니다</translation>
        </message>
        <message>
            <source>it is chosen already</source>
            <translation>이미 선택되어 있습니다</translation>
        </message>
        <message>
            <source>A sensor file (JSON) says which temperature modules and gauges hang on this machine: where each channel sits, its register, its scale. Put it into %1; docs/sensors.md has every key and an example.</source>
            <translation>센서 파일(JSON)에는 이 기계에 어떤 온도 모듈과 게이지가 연결되어 있는지, 각 채널의 위치, 레지스터, 배율이 적혀 있습니다. %1에 넣으십시오. 모든 키와 예제는 docs/sensors.md에 있습니다.</translation>
        </message>
    </context>
</TS>
