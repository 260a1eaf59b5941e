; Installs Unprojector for one user, without an administrator. /S asks nothing; /D=FOLDER (last, without quotes) chooses where.
; Given: TARGET (the kind of installer), VERSION, TREE (the files), REMOVAL (the lines that delete them), ICON, OUT.
Target ${TARGET}
Unicode true
SetCompressor /SOLID lzma
ManifestDPIAware true
RequestExecutionLevel user
!include MUI2.nsh
!include LogicLib.nsh
!include WinVer.nsh
!include x64.nsh
!include FileFunc.nsh
Name "Unprojector"
OutFile "${OUT}"
InstallDir "$LOCALAPPDATA\Programs\Unprojector"
InstallDirRegKey HKCU "Software\Unprojector\Setup" "Folder"
VIProductVersion "${VERSION}.0"
VIAddVersionKey "ProductName" "Unprojector"
VIAddVersionKey "FileDescription" "Unprojector setup"
VIAddVersionKey "FileVersion" "${VERSION}"
VIAddVersionKey "ProductVersion" "${VERSION}"
VIAddVersionKey "LegalCopyright" "MIT licence"
!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\Unprojector"
!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!define MUI_FINISHPAGE_RUN "$INSTDIR\unprojector.exe"
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"
!insertmacro MUI_LANGUAGE "SimpChinese"

LangString Needs64 ${LANG_ENGLISH} "Unprojector needs 64-bit Windows 10 or later."
LangString Needs64 ${LANG_SIMPCHINESE} "Unprojector 需要 64 位 Windows 10 或更高版本。"
LangString InUse ${LANG_ENGLISH} "Unprojector is running. Close it, then try again."
LangString InUse ${LANG_SIMPCHINESE} "Unprojector 正在运行。请先关闭它，然后重试。"
LangString FileKind ${LANG_ENGLISH} "Unprojector scene or model"
LangString FileKind ${LANG_SIMPCHINESE} "Unprojector 场景或模型"

; Offered under "Open with", also by Windows itself where nothing else opens such files; no other program loses its own.
!macro OfferFor SUFFIX
    WriteRegStr HKCU "Software\Classes\${SUFFIX}\OpenWithProgids" "Unprojector.File" ""
    WriteRegStr HKCU "Software\Classes\Applications\unprojector.exe\SupportedTypes" "${SUFFIX}" ""
!macroend
!macro TakeBackFrom SUFFIX
    DeleteRegValue HKCU "Software\Classes\${SUFFIX}\OpenWithProgids" "Unprojector.File"
    DeleteRegKey /ifempty HKCU "Software\Classes\${SUFFIX}\OpenWithProgids"
    DeleteRegKey /ifempty HKCU "Software\Classes\${SUFFIX}"
!macroend
!macro ForEachSuffix MACRO
    !insertmacro ${MACRO} ".json"
    !insertmacro ${MACRO} ".obj"
    !insertmacro ${MACRO} ".stl"
    !insertmacro ${MACRO} ".ply"
    !insertmacro ${MACRO} ".off"
    !insertmacro ${MACRO} ".gltf"
    !insertmacro ${MACRO} ".glb"
!macroend
; A program that runs cannot be written.
!macro StopWhereRunning
    ${If} ${FileExists} "$INSTDIR\unprojector.exe"
        ClearErrors
        FileOpen $0 "$INSTDIR\unprojector.exe" a
        ${If} ${Errors}
            MessageBox MB_OK|MB_ICONSTOP "$(InUse)" /SD IDOK
            SetErrorLevel 2
            Abort
        ${EndIf}
        FileClose $0
    ${EndIf}
!macroend

Function .onInit
    ${IfNot} ${AtLeastWin10}
    ${OrIfNot} ${RunningX64}
        MessageBox MB_OK|MB_ICONSTOP "$(Needs64)" /SD IDOK
        SetErrorLevel 2
        Abort
    ${EndIf}
FunctionEnd

Section
    !insertmacro StopWhereRunning
    ; Libraries of an older version that this one has no more would stay, and might be loaded.
    ${If} ${FileExists} "$INSTDIR\uninstall.exe"
        ExecWait '"$INSTDIR\uninstall.exe" /S /KEEPSETTINGS _?=$INSTDIR'
    ${EndIf}
    SetOutPath "$INSTDIR"
    File /r "${TREE}\*"
    WriteUninstaller "$INSTDIR\uninstall.exe"
    CreateShortcut "$SMPROGRAMS\Unprojector.lnk" "$INSTDIR\unprojector.exe"
    WriteRegStr HKCU "Software\Unprojector\Setup" "Folder" "$INSTDIR"
    WriteRegStr HKCU "Software\Classes\Unprojector.File" "" "$(FileKind)"
    WriteRegStr HKCU "Software\Classes\Unprojector.File\DefaultIcon" "" '"$INSTDIR\unprojector.exe",0'
    WriteRegStr HKCU "Software\Classes\Unprojector.File\shell\open\command" "" '"$INSTDIR\unprojector.exe" "%1"'
    WriteRegStr HKCU "Software\Classes\Applications\unprojector.exe\shell\open\command" "" '"$INSTDIR\unprojector.exe" "%1"'
    !insertmacro ForEachSuffix OfferFor
    WriteRegStr HKCU "${UNINSTALL}" "DisplayName" "Unprojector"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayVersion" "${VERSION}"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayIcon" "$INSTDIR\unprojector.exe"
    WriteRegStr HKCU "${UNINSTALL}" "Publisher" "The Unprojector authors"
    WriteRegStr HKCU "${UNINSTALL}" "InstallLocation" "$INSTDIR"
    WriteRegStr HKCU "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall.exe"'
    WriteRegStr HKCU "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
    WriteRegDWORD HKCU "${UNINSTALL}" "NoModify" 1
    WriteRegDWORD HKCU "${UNINSTALL}" "NoRepair" 1
    ${GetSize} "$INSTDIR" "/S=0K" $0 $1 $2
    IntFmt $0 "0x%08X" $0
    WriteRegDWORD HKCU "${UNINSTALL}" "EstimatedSize" $0
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, i 0, i 0)'
SectionEnd

Section "Uninstall"
    !insertmacro StopWhereRunning
    !include "${REMOVAL}"
    Delete "$INSTDIR\uninstall.exe"
    SetOutPath "$TEMP"
    RMDir "$INSTDIR"
    Delete "$SMPROGRAMS\Unprojector.lnk"
    !insertmacro ForEachSuffix TakeBackFrom
    DeleteRegKey HKCU "Software\Classes\Unprojector.File"
    DeleteRegKey HKCU "Software\Classes\Applications\unprojector.exe"
    DeleteRegKey HKCU "${UNINSTALL}"
    ${GetParameters} $0
    ClearErrors
    ${GetOptions} $0 "/KEEPSETTINGS" $1
    ${If} ${Errors}
        DeleteRegKey HKCU "Software\Unprojector"
    ${EndIf}
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, i 0, i 0)'
SectionEnd
