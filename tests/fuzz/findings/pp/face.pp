<!DOCTYPE PickedPoints>
<PickedPoints>
 <DocumentData>
  <DateTime date="2026-10-01" time="12:00:00"/>
  <User name="A &amp; B"/>
  <DataFileName name="face.ply"/>
  <templateName name=""/>
 </DocumentData>
 <!-- two -->
 <point x="1.5" y="-2" z="3e-2" active="1" name="N"/>
 <point x="0" y="0" z="0" active="0" name="gone"/>
</PickedPoints>
